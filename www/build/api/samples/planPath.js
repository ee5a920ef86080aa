import init, { planPath, presets } from "frond-ifs";

await init();
const shape = (name) => presets().find(({ id }) => id === name);
const { holds, points } = planPath(shape("dragon-3"), shape("gasket"), {});
console.log(holds);
console.log(points.map((point) => point.map((x) => x.toFixed(2)).join(",")).join("; "));

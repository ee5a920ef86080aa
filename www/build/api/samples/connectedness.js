import init, { connectedness, presets } from "frond-ifs";

await init();
const dragon = presets().find(({ id }) => id === "dragon");
const { verdict, reason } = connectedness(dragon, { epsilon: 1e-4 });
console.log(verdict, "-", reason.text);

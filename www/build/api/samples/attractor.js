import init, { attractor, presets } from "frond-ifs/draw";

await init();
const fern = presets().find(({ id }) => id === "fern");
const { positions, pieces } = attractor(fern, { points: 1000, seed: 1 });
console.log(positions.length, pieces.length); // 2000 1000

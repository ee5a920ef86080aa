import { writeFileSync } from "node:fs";
import init, { connectedness, presets, rasterize } from "frond-ifs";

await init();
const gasket = presets().find(({ id }) => id === "gasket");
const pixels = rasterize(gasket, { width: 400, height: 400 });
const grey = pixels.filter((_, i) => i % 4 === 3).map((alpha) => 255 - alpha);
writeFileSync("gasket.pgm", Buffer.concat([Buffer.from("P5\n400 400\n255\n"), Buffer.from(grey)]));
console.log(connectedness(gasket, { epsilon: 1e-4 }).verdict);

// A program for Node: `npm install frond-ifs`, then `node terminal.mjs dragon`. It draws a shape of the gallery with
// two pixels in each character, and says whether the shape is in one piece.
import init, { connectedness, presets, rasterize } from "frond-ifs";

await init();
const [, , wanted = "fern"] = process.argv;
const shape = presets().find(({ id }) => id === wanted);
if (!shape) {
  console.error(
    `There is no ${wanted}. There are: ${presets()
      .map(({ id }) => id)
      .join(", ")}`,
  );
  process.exit(2);
}

const [width, height] = [72, 64];
const pixels = rasterize(shape, { width, height });
const inked = (x, y) => pixels[4 * (y * width + x) + 3] > 64;
for (let y = 0; y < height; y += 2) {
  const row = Array.from(
    { length: width },
    (_, x) => " ▀▄█"[(inked(x, y) ? 1 : 0) + (inked(x, y + 1) ? 2 : 0)],
  );
  console.log(row.join("").trimEnd());
}
console.log(`${shape.name}: ${connectedness(shape).verdict}`);

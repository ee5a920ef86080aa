import init, { locus, presets } from "frond-ifs";

await init();
const shape = (name) => presets().find(({ id }) => id === name);
const [width, height] = [81, 81];
const { gap } = locus(shape("dragon-3"), shape("gasket"), { width, height });
// White where the shape holds together, darker where its gap is wider.
const pixels = Uint8ClampedArray.from({ length: 4 * width * height }, (_, i) =>
  i % 4 === 3 ? 255 : 255 - 600 * gap[i >> 2],
);
const canvas = document.querySelector("canvas");
canvas.getContext("2d").putImageData(new ImageData(pixels, width, height), 0, 0);

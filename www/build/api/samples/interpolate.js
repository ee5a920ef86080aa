import init, { interpolate, presets, rasterize } from "frond-ifs/draw";

await init();
const shape = (name) => presets().find(({ id }) => id === name);
const half = interpolate(shape("dragon-3"), shape("gasket"), { u: 0.5, v: 1.2 });
const pixels = rasterize(half, { width: 400, height: 400 });
const canvas = document.querySelector("canvas");
canvas.getContext("2d").putImageData(new ImageData(pixels, 400, 400), 0, 0);

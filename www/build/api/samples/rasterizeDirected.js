import init, { directedPresets, rasterizeDirected } from "frond-ifs/directed";

await init();
const [{ system }] = directedPresets();
const pixels = rasterizeDirected(system, { width: 400, height: 400 });
const canvas = document.querySelector("canvas");
canvas.getContext("2d").putImageData(new ImageData(pixels, 400, 400), 0, 0);

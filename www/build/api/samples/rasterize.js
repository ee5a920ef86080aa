import init, { rasterize } from "frond-ifs/draw";

await init();
const gasket = {
  maps: [
    [0.5, 0, 0, 0.5, 0, 0],
    [0.5, 0, 0, 0.5, 0.5, 0],
    [0.5, 0, 0, 0.5, 0.25, 0.433],
  ],
};
const pixels = rasterize(gasket, { width: 400, height: 400, palette: ["#0072b2", "#d55e00", "#009e73"] });
const canvas = document.querySelector("canvas");
canvas.getContext("2d").putImageData(new ImageData(pixels, 400, 400), 0, 0);

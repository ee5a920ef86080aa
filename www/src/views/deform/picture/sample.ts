import type { Photograph } from "../../../state/picture";

const WIDTH = 1200;
const HEIGHT = 900;

/** A picture to begin with, drawn here: the same every time. */
export function drawSample(): Photograph {
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  const context = canvas.getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("This browser draws on no canvas.");
  const sky = context.createLinearGradient(0, 0, 0, HEIGHT);
  sky.addColorStop(0, "#2b3f7a");
  sky.addColorStop(1, "#f6c98a");
  context.fillStyle = sky;
  context.fillRect(0, 0, WIDTH, HEIGHT);
  const { data } = context.getImageData(0, 0, WIDTH, HEIGHT);
  return { pixels: data, width: WIDTH, height: HEIGHT, name: "Sample" };
}

// There is neither a canvas nor a graphics card in Node: what needs one says so.
import { FrondError } from "../guard.js";

export * from "../renderer.js";

async function noCanvas() {
  const message =
    "Node has no canvas. Draw with rasterize() of frond-ifs/draw, or SpacePicture of frond-ifs/space.";
  throw new FrondError("no-canvas", message);
}

export { noCanvas as createRenderer, noCanvas as createSpaceRenderer };

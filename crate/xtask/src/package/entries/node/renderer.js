// There is neither a canvas nor a graphics card in Node: what needs one says so.
export * from "../renderer.js";

async function noCanvas() {
  const message =
    "Node has no canvas. Draw with rasterize() of frond-ifs/draw, or SpacePicture of frond-ifs/space.";
  throw Object.assign(new Error(message), { code: "no-canvas" });
}

export { noCanvas as createRenderer, noCanvas as createSpaceRenderer };

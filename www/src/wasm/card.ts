import { hasGraphicsCard } from "../../pkg/renderer.js";
import { lacksWebGpu } from "./webgpu";

/** What drivers without a graphics card call themselves. */
const SOFTWARE = /swiftshader|llvmpipe|lavapipe|softpipe|software|basic render|\bwarp\b/i;

/** Whether a driver of this name has the processor stand in for a graphics card. */
export const isSoftware = (name: string): boolean => SOFTWARE.test(name);

/** Whether there is a graphics card behind the interface that a renderer would take. Asked once. */
export const hasCard = (): Promise<boolean> => (asked ??= ask());

let asked: Promise<boolean> | undefined;

async function ask(): Promise<boolean> {
  return (await lacksWebGpu()) ? cardOfWebGl() : hasGraphicsCard();
}

function cardOfWebGl(): boolean {
  const context = document.createElement("canvas").getContext("webgl2");
  if (!context) return false;
  // Some browsers tell the name only by this.
  const told = context.getExtension("WEBGL_debug_renderer_info");
  const name = String(context.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return !isSoftware(name);
}

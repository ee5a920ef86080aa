import { explainMissing } from "#stage/surface/missing";
import type { PainterBackend } from "#stage/surface/painter";
import { createSpaceRenderer } from "#wasm/space-renderer";
import { drawsInSoftware } from "#wasm/webgpu";
import { Accelerated } from "./accelerated";
import { Plain } from "./plain";
import type { Surface } from "./surface";

/**
 * A surface on a canvas that has had no context yet: on the graphics card, or where there is none, without it. Where
 * the processor would stand in for a card it rather carves: it has as much to do, and what moves has faces, not points.
 */
export async function openSurface(
  backend: "auto" | PainterBackend,
  onLost: (reason: string) => void,
): Promise<Surface> {
  if (backend !== "canvas" && (backend !== "auto" || !(await drawsInSoftware()))) {
    const canvas = blank();
    try {
      return new Accelerated(await createSpaceRenderer(canvas, { backend, onLost }), canvas);
    } catch (problem) {
      explainMissing(problem);
    }
  }
  // A canvas that has had one kind of context gives no other.
  return new Plain(blank());
}

function blank(): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.setAttribute("aria-hidden", "true");
  return canvas;
}

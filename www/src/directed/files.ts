/** Graph-directed shapes as the text of a file. */
import type { DirectedIfs, Scene } from "#wasm/api";
import * as messages from "./messages";

const ABOUT = messages.documentFrondUnderDirected;

/** The whole document, which opens again; with the system of its moment where that is known. */
export function jsonOf(scene: Scene, now: DirectedIfs | null): string {
  return `${JSON.stringify({ about: ABOUT, ...scene, ...(now ? { now: now.states } : {}) })}\n`;
}

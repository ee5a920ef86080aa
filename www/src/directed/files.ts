/** Graph-directed shapes as the text of a file. */
import type { DirectedIfs, Scene } from "#wasm/api";

const ABOUT =
  "A document of Frond: under `directed` two graph-directed shapes. Each state is the union of copies of states, and the first state is the shape; `from` is the state that is copied, from 0, and maps are [a, b, c, d, e, f]: x' = a x + b y + e, y' = c x + d y + f, with y pointing up. `now` is the system at the moment t.";

/** The whole document, which opens again; with the system of its moment where that is known. */
export function jsonOf(scene: Scene, now: DirectedIfs | null): string {
  return `${JSON.stringify({ about: ABOUT, ...scene, ...(now ? { now: now.states } : {}) })}\n`;
}

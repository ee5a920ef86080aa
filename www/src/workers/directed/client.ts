import { compileDirected } from "#wasm/directed";
import { client } from "../lanes/client";
import { performer } from "./performer";
import type { Tasks } from "./tasks";

/**
 * Pictures are asked for in lane 0, what is said of the present moment in lane 1, what may take longest in lane 2, and
 * where the morph holds together in lane 3.
 */
export type DirectedLane = 0 | 1 | 2 | 3;

/** Asks the workers of graph-directed shapes for something. */
export const directedTask = client<Tasks, DirectedLane>({
  module: compileDirected,
  worker: () =>
    new Worker(new URL("./directed.worker.ts", import.meta.url), { type: "module", name: "frond-directed" }),
  performer,
  lane: 0,
});

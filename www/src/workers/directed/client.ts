import { compileDirected } from "#wasm/directed";
import { client } from "../lanes/client";
import { performer } from "./performer";
import type { Tasks } from "./tasks";

/** Asks the workers of graph-directed shapes for something: pictures in lane 0, what takes longer in lane 1. */
export const directedTask = client<Tasks, 0 | 1>({
  module: compileDirected,
  worker: () =>
    new Worker(new URL("./directed.worker.ts", import.meta.url), { type: "module", name: "frond-directed" }),
  performer,
  lane: 0,
});

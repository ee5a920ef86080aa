import { compile } from "#wasm/core";
import { client } from "../lanes/client";
import { performer } from "./performer";
import type { Tasks } from "./tasks";

/** Two frames are drawn at once, each in a lane of its own. */
export type FrameLane = 0 | 1;

/** Has frames of attractors drawn, by workers that do nothing else: nothing is before them. */
export const frameTask = client<Tasks, FrameLane>({
  module: () => compile(),
  worker: () =>
    new Worker(new URL("./frames.worker.ts", import.meta.url), { type: "module", name: "frond-frames" }),
  performer,
  lane: 0,
});

import { compileFit } from "#wasm/fit";
import { client } from "../lanes/client";
import { performer } from "./performer";
import type { Tasks } from "./tasks";

/** Asks the two workers of the fit for something. */
export const fitTask = client<Tasks, 0 | 1>({
  module: compileFit,
  worker: () =>
    new Worker(new URL("./fit.worker.ts", import.meta.url), {
      type: "module",
      name: "frond-fit",
    }),
  performer,
  lane: 0,
});

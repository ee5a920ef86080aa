import { compileSpace } from "#wasm/space";
import { crew } from "../film/crew";
import { client } from "../lanes/client";
import { performer } from "./performer";
import type { Tasks } from "./tasks";

const workers = {
  module: compileSpace,
  worker: () =>
    new Worker(new URL("./space.worker.ts", import.meta.url), {
      type: "module",
      name: "frond-space",
    }),
  performer,
};

/**
 * Asks the workers of space for something. Lanes 0 and 4 are the stage's own, so that a picture never waits; 1, where a
 * task goes that does not say, is for what is short; 2 and 3 are for what is long.
 */
export const spaceTask = client<Tasks, 0 | 1 | 2 | 3 | 4>({ ...workers, lane: 1 });

/** Workers for one film. */
export const spaceCrew = () => crew<Tasks>(workers);

import { startSpace } from "#wasm/space";
import { performerOf } from "../lanes/performer";
import { tasks } from "./tasks";

/** The inside of a worker of space: its tasks have `solid`, as the page does. */
export const performer = performerOf(
  tasks,
  async (module) => {
    await startSpace(module);
    return {};
  },
  // Frames are asked for one after the other.
  true,
);

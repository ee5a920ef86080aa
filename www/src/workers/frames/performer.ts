import { adopt } from "#wasm/core";
import { performerOf } from "../lanes/performer";
import { tasks } from "./tasks";

/** The inside of a worker that draws frames. */
export const performer = performerOf(
  tasks,
  async (module) => {
    await adopt(module);
    return {};
  },
  true,
);

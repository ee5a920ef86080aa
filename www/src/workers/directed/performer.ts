import { startDirected } from "#wasm/directed";
import { performerOf } from "../lanes/performer";
import { tasks } from "./tasks";

/** The inside of a worker of graph-directed shapes: its tasks have `directed`, as the page does. */
export const performer = performerOf(tasks, async (module) => {
  await startDirected(module);
  return {};
});

/** The workers of the command: those of the package's pool, which draw and pack its frames as well. */
import { performerOf } from "#workers/lanes/performer";
import { tasks } from "../tasks";
import { type FrameSources, frameTasks } from "./draw/frame";

export { lanesOf, poolOn } from "../pool";

/** The inside of a worker. */
export const performerFrom = (sources: FrameSources) =>
  performerOf({ ...tasks, ...frameTasks }, async () => ({ sources }));

import type { Context } from "./context";
import { curveTasks } from "./curve";
import { houghTasks } from "./hough";
import { traceTasks } from "./trace";

/** Each room of work has a file of tasks. */
export const tasks = {
  /** Nothing: so that the first real one finds the worker ready. */
  wake: (_context: Context, _args: Record<string, never>): null => null,
  ...curveTasks,
  ...houghTasks,
  ...traceTasks,
};

export type Tasks = typeof tasks;

import type { Context as Plain } from "../lanes/task";
import type { FitModule } from "./module";
import { curveTasks } from "./tasks/curve";
import { houghTasks } from "./tasks/hough";
import { traceTasks } from "./tasks/trace";

/** What a task has at hand. */
export interface Context<Progress = never> extends Plain<Progress> {
  readonly fit: FitModule;
}

/** Each room of work has a file of tasks. */
export const tasks = {
  /** Nothing: so that the first real one finds the worker ready. */
  wake: (_context: Context, _args: Record<string, never>): null => null,
  ...curveTasks,
  ...houghTasks,
  ...traceTasks,
};

export type Tasks = typeof tasks;

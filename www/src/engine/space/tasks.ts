import type { Context } from "../lanes/task";
import { exportTasks } from "./tasks/export";
import { morphTasks } from "./tasks/morph";
import { pictureTasks } from "./tasks/picture";
import { shapeTasks } from "./tasks/shape";

/** Each room of work has a file of tasks. They compute with `solid`, which is started before the first. */
export const tasks = {
  /** Nothing: so that the first real one finds the worker ready. */
  wake: (_context: Context, _args: Record<string, never>): null => null,
  ...exportTasks,
  ...morphTasks,
  ...pictureTasks,
  ...shapeTasks,
};

export type Tasks = typeof tasks;

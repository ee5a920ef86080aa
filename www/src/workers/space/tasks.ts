import type { Context } from "../lanes/task";
import { exportTasks } from "./export";
import { meshTasks } from "./mesh";
import { morphTasks } from "./morph";
import { pictureTasks } from "./picture";
import { shapeTasks } from "./shape";

/** Each room of work has a file of tasks. They compute with `solid`, which is started before the first. */
export const tasks = {
  /** Nothing: so that the first real one finds the worker ready. */
  wake: (_context: Context, _args: Record<string, never>): null => null,
  ...exportTasks,
  ...meshTasks,
  ...morphTasks,
  ...pictureTasks,
  ...shapeTasks,
};

export type Tasks = typeof tasks;

import type { FitModule } from "./module";
import { curveTasks } from "./tasks/curve";
import { houghTasks } from "./tasks/hough";
import { traceTasks } from "./tasks/trace";

/** What a task has at hand. */
export interface Context<Progress = never> {
  readonly fit: FitModule;
  /** What has been reached: the one who asked is told at once. */
  progress(value: Progress, transfer?: Transferable[]): void;
  /** To be awaited every 50 ms or so: word that it is to stop comes meanwhile, and is thrown as `{ code: "stopped" }`. */
  breathe(): Promise<void>;
  /** Handed over with the result instead of copied. */
  transfer(...values: Transferable[]): void;
  /** What lives between the tasks of a lane, by name: handles and pictures. It is gone when its worker dies. */
  readonly keep: Map<string, unknown>;
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
export type Name = keyof Tasks;
export type Args<K extends Name> = Parameters<Tasks[K]>[1];
export type Result<K extends Name> = Awaited<ReturnType<Tasks[K]>>;
export type ProgressOf<K extends Name> = Parameters<Tasks[K]>[0] extends Context<infer P> ? P : never;

/** To the worker. */
export type Ask =
  | { type: "start"; module: WebAssembly.Module }
  | { type: "run"; id: number; name: Name; args: unknown }
  | { type: "stop"; id: number };

/** From the worker. */
export type Answer =
  | { type: "progress"; id: number; value: unknown }
  | { type: "done"; id: number; result: unknown }
  | { type: "failed"; id: number; error: { code: string; message: string }; fatal: boolean };

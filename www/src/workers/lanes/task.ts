/** What a task has at hand. */
export interface Context<Progress = never> {
  /** What has been reached: the one who asked is told at once. */
  progress(value: Progress, transfer?: Transferable[]): void;
  /**
   * To be awaited every 50 ms or so: word that it is to stop comes meanwhile, and is thrown as `{ code: "stopped" }`.
   */
  breathe(): Promise<void>;
  /** Handed over with the result instead of copied. */
  transfer(...values: Transferable[]): void;
  /** What lives between the tasks of a lane, by name: handles and pictures. It is gone when its worker dies. */
  readonly keep: Map<string, unknown>;
}

/** Tasks by name. */
// biome-ignore lint/suspicious/noExplicitAny: each has its own context and arguments
export type Table = Record<string, (context: any, args: any) => unknown>;

export type Name<T extends Table> = Extract<keyof T, string>;
export type Args<T extends Table, K extends keyof T> = Parameters<T[K]>[1];
export type Result<T extends Table, K extends keyof T> = Awaited<ReturnType<T[K]>>;
export type ProgressOf<T extends Table, K extends keyof T> =
  Parameters<T[K]>[0] extends Context<infer P> ? P : never;

/** To the worker; `M` is what it computes with. */
export type Ask<M = WebAssembly.Module> =
  | { type: "start"; module: M }
  | { type: "run"; id: number; name: string; args: unknown }
  | { type: "stop"; id: number };

/**
 * From the worker: that it has its module, or why not; then of the task under way. `fatal`: its module cannot be
 * trusted any more, and it asks to be replaced.
 */
export type Answer =
  | { type: "ready" }
  | { type: "unable"; error: { code: string; message: string } }
  | { type: "progress"; id: number; value: unknown }
  | { type: "done"; id: number; result: unknown; milliseconds: number }
  | { type: "failed"; id: number; error: { code: string; message: string }; fatal: boolean };

/** As much of a `Worker` as is needed; the tests put their own in its place. */
export interface WorkerLike<M = WebAssembly.Module> {
  postMessage(message: Ask<M>, transfer?: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Answer>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

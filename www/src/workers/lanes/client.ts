import { Lane } from "./lane";
import { OnPage } from "./on-page";
import type { Performer } from "./performer";
import type { Args, Name, ProgressOf, Result, Table, WorkerLike } from "./task";

export interface Options<T extends Table, K extends keyof T, L extends number> {
  /** Calls it off: the promise is rejected with `{ code: "stopped" }`. */
  signal?: AbortSignal;
  onProgress?: (value: ProgressOf<T, K>) => void;
  transfer?: Transferable[];
  /** Which of the workers. What a task keeps is there for the next one of the same lane. */
  lane?: L;
}

export interface Workers<L extends number> {
  /** Fetches and compiles what they compute with. */
  module: () => Promise<WebAssembly.Module>;
  worker: () => Worker;
  /** What does the work on the page where there are no workers. */
  performer: Performer;
  /** Where a task goes that does not say. */
  lane: L;
}

/** What asks workers for the tasks of a table. They are started, and their module fetched, when first needed. */
export function client<T extends Table, L extends number>(workers: Workers<L>) {
  const lanes = new Map<number, Lane>();
  let next = 1;

  return function task<K extends Name<T>>(
    name: K,
    args: Args<T, K>,
    options: Options<T, K, L> = {},
  ): Promise<Result<T, K>> {
    const number = options.lane ?? workers.lane;
    const lane = lanes.get(number) ?? new Lane(() => spawn(workers), workers.module);
    lanes.set(number, lane);
    const { signal } = options;
    const id = next++;
    return new Promise<Result<T, K>>((resolve, reject) => {
      if (signal?.aborted) {
        reject({ code: "stopped", message: "Something else was asked for." });
        return;
      }
      signal?.addEventListener("abort", () => lane.stop(id), { once: true });
      lane.give({
        ask: { type: "run", id, name, args },
        transfer: options.transfer ?? [],
        onProgress: (value) => options.onProgress?.(value as ProgressOf<T, K>),
        resolve: (result) => resolve(result as Result<T, K>),
        reject,
      });
    });
  };
}

function spawn<L extends number>({ worker, performer }: Workers<L>): WorkerLike {
  const none = new URL(location.href).searchParams.get("workers") === "0" || typeof Worker === "undefined";
  return none ? new OnPage(performer) : (worker() as WorkerLike);
}

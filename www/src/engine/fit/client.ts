import { Lane, type WorkerLike } from "./lane";
import { compileFit } from "./module";
import { performer } from "./performer";
import type { Answer, Args, Name, ProgressOf, Result } from "./tasks";

export interface Options<K extends Name> {
  /** Calls it off: the promise is rejected with `{ code: "stopped" }`. */
  signal?: AbortSignal;
  onProgress?: (value: ProgressOf<K>) => void;
  transfer?: Transferable[];
  /** Which of the two workers. What a task keeps is there for the next one of the same lane. Default 0. */
  lane?: 0 | 1;
}

let lanes: [Lane, Lane] | null = null;
let next = 1;

/** Asks the workers of the fit for something. They are started, and their module fetched, when first needed. */
export function fitTask<K extends Name>(
  name: K,
  args: Args<K>,
  options: Options<K> = {},
): Promise<Result<K>> {
  lanes ??= [new Lane(spawn, compileFit), new Lane(spawn, compileFit)];
  const lane = lanes[options.lane ?? 0];
  const { signal } = options;
  const id = next++;
  return new Promise<Result<K>>((resolve, reject) => {
    if (signal?.aborted) {
      reject({ code: "stopped", message: "Something else was asked for." });
      return;
    }
    signal?.addEventListener("abort", () => lane.stop(id), { once: true });
    void lane.give({
      ask: { type: "run", id, name, args },
      transfer: options.transfer ?? [],
      onProgress: (value) => options.onProgress?.(value as ProgressOf<K>),
      resolve: (result) => resolve(result as Result<K>),
      reject,
    });
  });
}

function spawn(): WorkerLike {
  const none = new URL(location.href).searchParams.get("workers") === "0" || typeof Worker === "undefined";
  if (none) return new OnPage();
  return new Worker(new URL("../../workers/fit.worker.ts", import.meta.url), {
    type: "module",
    name: "frond-fit",
  }) as WorkerLike;
}

/** Stands in for a worker where none can be had. */
class OnPage implements WorkerLike {
  onmessage: WorkerLike["onmessage"] = null;
  onerror: WorkerLike["onerror"] = null;
  readonly postMessage = performer((data) => this.onmessage?.({ data } as MessageEvent<Answer>));

  terminate(): void {
    this.onmessage = null;
  }
}

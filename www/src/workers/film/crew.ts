import { compileSpace } from "#wasm/space";
import { client } from "../lanes/client";
import { performer } from "../space/performer";
import type { Tasks } from "../space/tasks";

/** Workers of their own for one film, so that it keeps nothing else waiting. They go when it is made. */
export function crew() {
  const workers: Worker[] = [];
  const task = client<Tasks, number>({
    module: compileSpace,
    worker: () => {
      const worker = new Worker(new URL("../space/space.worker.ts", import.meta.url), {
        type: "module",
        name: "frond-film",
      });
      workers.push(worker);
      return worker;
    },
    performer,
    lane: 0,
  });
  return {
    task,
    end() {
      for (const worker of workers) worker.terminate();
    },
  };
}

/** Pixels that all of them may carve at a time: each takes some 10 bytes. */
const MOST_CARVED = 50e6;
const MOST_WORKERS = 8;

/** How many draw frames of so many carved pixels; one core is left for the page. */
export function painters(carved: number, cores: number): number {
  return Math.max(1, Math.min(MOST_WORKERS, cores - 1, Math.floor(MOST_CARVED / Math.max(1, carved))));
}

import { client, type Workers } from "../lanes/client";
import type { Table } from "../lanes/task";

/** Workers of their own for one film, so that it keeps nothing else waiting. They go when it is made. */
export function crew<T extends Table>(workers: Omit<Workers<number>, "lane">) {
  const started: Worker[] = [];
  const task = client<T, number>({
    ...workers,
    worker: () => {
      const worker = workers.worker();
      started.push(worker);
      return worker;
    },
    lane: 0,
  });
  return {
    task,
    end() {
      for (const worker of started) worker.terminate();
    },
  };
}

/** Pixels that all of them may draw at a time: each takes some 10 bytes. */
const MOST_DRAWN = 50e6;
const MOST_WORKERS = 8;

/** How many draw frames of so many pixels; one core is left for the page. */
export function painters(pixels: number, cores = globalThis.navigator?.hardwareConcurrency ?? 2): number {
  return Math.max(1, Math.min(MOST_WORKERS, cores - 1, Math.floor(MOST_DRAWN / Math.max(1, pixels))));
}

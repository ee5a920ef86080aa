/** Workers that take jobs in turn. */
import DrawingWorker from "./element.worker?worker&inline";
import type { Answer, FromWorker, Job, ToWorker } from "./protocol";
import { work } from "./work";

const MOST_WORKERS = 2;

interface Waiting {
  job: Job;
  resolve(result: unknown): void;
  reject(problem: unknown): void;
}

export class Pool {
  #free: Worker[] = [];
  readonly #all = new Set<Worker>();
  readonly #queue: Waiting[] = [];
  readonly #busy = new Map<number, Waiting>();
  #next = 0;

  constructor(module: WebAssembly.Module) {
    const cores = navigator.hardwareConcurrency || 2;
    for (let i = 0; i < Math.min(MOST_WORKERS, Math.max(1, cores - 1)); i++) this.#start(module);
  }

  #start(module: WebAssembly.Module): void {
    try {
      const worker = new DrawingWorker();
      worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#answered(worker, data);
      // A page that allows no such worker says so by this: then the page itself draws.
      worker.onerror = () => this.#lost(worker);
      this.#all.add(worker);
      this.#free.push(worker);
      worker.postMessage({ module } satisfies ToWorker);
    } catch {
      // Refused at once.
    }
  }

  ask<J extends Job>(job: J): Promise<Answer<J>> {
    return new Promise((resolve, reject) => {
      this.#queue.push({ job, resolve: resolve as Waiting["resolve"], reject });
      this.#go();
    });
  }

  #go(): void {
    while (this.#queue.length > 0) {
      const worker = this.#free.pop();
      if (!worker && this.#all.size > 0) return;
      const waiting = this.#queue.shift();
      if (!waiting) return;
      if (!worker) {
        work(waiting.job).then(waiting.resolve, waiting.reject);
        continue;
      }
      const id = this.#next++;
      this.#busy.set(id, waiting);
      workOf.set(worker, id);
      worker.postMessage({ id, job: waiting.job } satisfies ToWorker);
    }
  }

  #answered(worker: Worker, { id, result, failure }: FromWorker): void {
    const waiting = this.#busy.get(id);
    this.#busy.delete(id);
    this.#free.push(worker);
    if (failure) waiting?.reject(failure);
    else waiting?.resolve(result);
    this.#go();
  }

  #lost(worker: Worker): void {
    this.#all.delete(worker);
    this.#free = this.#free.filter((free) => free !== worker);
    const id = workOf.get(worker);
    const waiting = id === undefined ? undefined : this.#busy.get(id);
    if (id !== undefined) this.#busy.delete(id);
    if (waiting) this.#queue.unshift(waiting);
    worker.terminate();
    this.#go();
  }

  /** Ends the workers; what they had to do is asked for again by whoever still wants it. */
  close(): void {
    for (const worker of this.#all) worker.terminate();
    this.#all.clear();
    for (const { reject } of [...this.#busy.values(), ...this.#queue])
      reject({ code: "cancelled", message: "It is no longer shown." });
  }
}

/** Which job each worker has. */
const workOf = new WeakMap<Worker, number>();

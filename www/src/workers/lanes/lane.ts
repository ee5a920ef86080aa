import type { Answer, Ask } from "./task";

/** As much of a `Worker` as a lane needs; the tests put their own in its place. */
export interface WorkerLike {
  postMessage(message: Ask, transfer?: Transferable[]): void;
  terminate(): void;
  onmessage: ((event: MessageEvent<Answer>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
}

export interface Order {
  ask: Extract<Ask, { type: "run" }>;
  transfer: Transferable[];
  onProgress: (value: unknown) => void;
  resolve: (result: unknown) => void;
  reject: (problem: unknown) => void;
}

/** A task that does not answer to "stop" for so long is ended with its worker. */
const GRACE_MS = 3000;
const LOST = { code: "worker-lost", message: "This could not be computed: its worker died. Try it again." };

/** One worker and what it has been asked. It is started when first needed, and again when it has died. */
export class Lane {
  readonly #spawn: () => WorkerLike;
  readonly #module: () => Promise<WebAssembly.Module>;
  #worker: WorkerLike | null = null;
  readonly #open = new Map<number, Order>();

  constructor(spawn: () => WorkerLike, module: () => Promise<WebAssembly.Module>) {
    this.#spawn = spawn;
    this.#module = module;
  }

  async give(order: Order): Promise<void> {
    this.#open.set(order.ask.id, order);
    try {
      const module = await this.#module();
      // It may have been called off meanwhile.
      if (!this.#open.has(order.ask.id)) return;
      this.#worker ??= this.#start(module);
      this.#worker.postMessage(order.ask, order.transfer);
    } catch (problem) {
      this.#take(order.ask.id)?.reject(problem);
    }
  }

  /** The one who asked hears at once that it is stopped; the worker as soon as it breathes. */
  stop(id: number): void {
    const order = this.#take(id);
    if (!order) return;
    order.reject({ code: "stopped", message: "Something else was asked for." });
    const worker = this.#worker;
    if (!worker) return;
    worker.postMessage({ type: "stop", id });
    this.#stopping.add(id);
    setTimeout(() => {
      if (worker === this.#worker && this.#stopping.has(id)) this.#lose();
    }, GRACE_MS);
  }

  readonly #stopping = new Set<number>();

  #start(module: WebAssembly.Module): WorkerLike {
    const worker = this.#spawn();
    worker.onmessage = (event) => this.#hear(event.data);
    worker.onerror = (event) => {
      event.preventDefault?.();
      this.#lose();
    };
    worker.postMessage({ type: "start", module });
    return worker;
  }

  #hear(answer: Answer): void {
    if (answer.type === "progress") {
      this.#open.get(answer.id)?.onProgress(answer.value);
      return;
    }
    this.#stopping.delete(answer.id);
    const order = this.#take(answer.id);
    if (answer.type === "done") order?.resolve(answer.result);
    else order?.reject(answer.error);
    if (answer.type === "failed" && answer.fatal) this.#lose();
  }

  #take(id: number): Order | undefined {
    const order = this.#open.get(id);
    this.#open.delete(id);
    return order;
  }

  /** What was under way is lost, and what it kept; the next task starts another. */
  #lose(): void {
    const worker = this.#worker;
    this.#worker = null;
    this.#stopping.clear();
    if (worker) {
      worker.onmessage = null;
      worker.onerror = null;
      worker.terminate();
    }
    const open = [...this.#open.values()];
    this.#open.clear();
    for (const order of open) order.reject(LOST);
  }
}

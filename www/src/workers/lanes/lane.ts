import type { Answer, Ask, WorkerLike } from "./task";

export interface Order {
  ask: Extract<Ask, { type: "run" }>;
  transfer: Transferable[];
  onProgress: (value: unknown) => void;
  resolve: (result: unknown) => void;
  reject: (problem: unknown) => void;
}

/** A task that does not answer to "stop" for so long is ended with its worker, once another waits for it. */
const GRACE_MS = 3000;

const STOPPED = { code: "stopped", message: "Something else was asked for." };
const LOST = { code: "worker-lost", message: "This could not be computed: its worker died. Try it again." };

/** What the worker has been given. */
interface Running {
  order: Order;
  /** It is called off, and the one who asked has been told. */
  stopped: boolean;
  overdue: boolean;
  /** Until it is. */
  grace?: ReturnType<typeof setTimeout>;
}

/**
 * One worker and what it has been asked, one task after the other. It is started when first needed, and again when it
 * has died. What waits, waits here: a worker that ends takes nothing with it but the task under way.
 */
export class Lane<M = WebAssembly.Module> {
  readonly #spawn: () => WorkerLike<M>;
  readonly #module: () => Promise<M>;
  #worker: WorkerLike<M> | null = null;
  #fetching = false;
  /** The worker has its module. One that is slow to start has nothing to answer for. */
  #ready = false;
  #running: Running | null = null;
  #waiting: Order[] = [];
  /** Asked once more because their worker died. */
  readonly #again = new WeakSet<Order>();

  constructor(spawn: () => WorkerLike<M>, module: () => Promise<M>) {
    this.#spawn = spawn;
    this.#module = module;
  }

  give(order: Order): void {
    this.#waiting.push(order);
    this.#pump();
  }

  /** The one who asked hears at once that it is stopped; the worker as soon as it breathes. */
  stop(id: number): void {
    const running = this.#running;
    if (running?.order.ask.id === id && !running.stopped) {
      running.stopped = true;
      running.order.reject(STOPPED);
      this.#worker?.postMessage({ type: "stop", id });
      running.grace = setTimeout(() => {
        running.overdue = true;
        this.#pump();
      }, GRACE_MS);
      return;
    }
    const order = this.#waiting.find((waiting) => waiting.ask.id === id);
    this.#waiting = this.#waiting.filter((waiting) => waiting !== order);
    order?.reject(STOPPED);
  }

  /** Ends the worker. Whoever waits hears that it is stopped. */
  close(): void {
    const running = this.#running;
    this.#end();
    if (running && !running.stopped) running.order.reject(STOPPED);
    this.#fail(STOPPED);
  }

  #pump(): void {
    if (this.#running?.overdue && this.#waiting.length > 0) this.#lose();
    const order = this.#waiting[0];
    if (!order || this.#running) return;
    if (!this.#worker) void this.#start();
    else if (this.#ready) {
      this.#waiting.shift();
      this.#running = { order, stopped: false, overdue: false };
      try {
        this.#worker.postMessage(order.ask, order.transfer);
      } catch (problem) {
        this.#running = null;
        order.reject(problem);
        this.#pump();
      }
    }
  }

  async #start(): Promise<void> {
    if (this.#fetching) return;
    this.#fetching = true;
    try {
      const module = await this.#module();
      // All may have been called off meanwhile.
      if (this.#waiting.length === 0) return;
      const worker = this.#spawn();
      this.#worker = worker;
      worker.onmessage = (event) => this.#hear(event.data);
      worker.onerror = (event) => {
        event.preventDefault?.();
        this.#lose();
      };
      worker.postMessage({ type: "start", module });
    } catch (problem) {
      this.#fail(problem);
    } finally {
      this.#fetching = false;
    }
  }

  #hear(answer: Answer): void {
    if (answer.type === "ready") this.#ready = true;
    else if (answer.type === "unable") {
      this.#end();
      this.#fail(answer.error);
    } else if (this.#running?.order.ask.id === answer.id) {
      const { order, stopped } = this.#running;
      if (answer.type === "progress") {
        if (!stopped) order.onProgress(answer.value);
        return;
      }
      clearTimeout(this.#running.grace);
      this.#running = null;
      if (answer.type === "done") order.resolve(answer.result);
      else order.reject(answer.error);
      if (answer.type === "failed" && answer.fatal) this.#end();
    }
    this.#pump();
  }

  /** The worker is dead: what was under way is asked once more, unless it handed something over that is gone now. */
  #lose(): void {
    const ready = this.#ready;
    const running = this.#running;
    this.#end();
    if (running && !running.stopped) {
      const { order } = running;
      if (order.transfer.length > 0 || this.#again.has(order)) order.reject(LOST);
      else {
        this.#again.add(order);
        this.#waiting.unshift(order);
      }
    }
    if (ready) this.#pump();
    else this.#fail(LOST);
  }

  #end(): void {
    const worker = this.#worker;
    this.#worker = null;
    this.#ready = false;
    clearTimeout(this.#running?.grace);
    this.#running = null;
    if (!worker) return;
    worker.onmessage = null;
    worker.onerror = null;
    worker.terminate();
  }

  /** There is no worker to be had. */
  #fail(problem: unknown): void {
    const orders = this.#waiting;
    this.#waiting = [];
    for (const order of orders) order.reject(problem);
  }
}

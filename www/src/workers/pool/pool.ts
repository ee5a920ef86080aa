import type { FrondError } from "#wasm/api";
import type { Answer, WorkerLike } from "../lanes/task";
import type { Channel, Job, Modules, Result, Task } from "./protocol";

interface PoolOptions {
  count: number;
  spawn: () => WorkerLike<Modules>;
  modules: Modules;
  onChange?: (state: { count: number; busy: boolean }) => void;
  /** No worker could be started, and maybe why: nothing will be handed out any more. */
  onUnavailable?: (problem: unknown) => void;
}

interface Entry {
  job: Job;
  live: boolean;
  inFlight: number;
  /** Slices that were taken from the job and wait, as urgent as they were when they were taken. */
  again: Waiting[];
}

interface Waiting {
  task: Task;
  tries: number;
  urgency: number;
}

interface Seat {
  worker: WorkerLike<Modules>;
  ready: boolean;
  work: (Waiting & { id: number; entry: Entry }) | null;
  watch: ReturnType<typeof setTimeout> | null;
}

/** A worker that is silent for so long is taken for dead; a slice is some ten milliseconds. */
const SILENCE_MS = 20_000;
const TRIES = 3;

/**
 * Hands slices of the most urgent jobs to workers. A job replaces the earlier one of its channel at once. Unlike a
 * lane, which keeps what it was asked in the order that it came, it chooses anew whenever a worker comes free.
 */
export class Pool {
  readonly #options: PoolOptions;
  readonly #entries = new Map<Channel, Entry>();
  #seats: Seat[] = [];
  #nextId = 1;
  #failedStarts = 0;
  #problem: unknown = null;
  #closed = false;

  constructor(options: PoolOptions) {
    this.#options = options;
    for (let i = 0; i < options.count; i++) this.#seat();
    this.#report();
  }

  submit(job: Job): void {
    this.cancel(job.channel);
    this.#entries.set(job.channel, { job, live: true, inFlight: 0, again: [] });
    this.#pump();
  }

  /** What is under way ends unheard; nothing more is handed out. */
  cancel(channel: Channel): void {
    const entry = this.#entries.get(channel);
    if (!entry) return;
    entry.live = false;
    this.#entries.delete(channel);
    for (const { work, worker } of this.#seats) {
      if (work?.entry === entry) worker.postMessage({ type: "stop", id: work.id });
    }
    this.#report();
  }

  get busy(): boolean {
    return this.#entries.size > 0;
  }

  /** For tests: one worker dies as if the browser had killed it, the busiest first. */
  killOne(): void {
    const seat = this.#seats.find((s) => s.work) ?? this.#seats[0];
    if (seat) this.#replace(seat);
  }

  close(): void {
    this.#closed = true;
    for (const seat of this.#seats) this.#vacate(seat);
    this.#seats = [];
  }

  #seat(): void {
    let worker: WorkerLike<Modules>;
    try {
      worker = this.#options.spawn();
    } catch (problem) {
      this.#problem = problem;
      this.#startFailed();
      return;
    }
    const seat: Seat = { worker, ready: false, work: null, watch: null };
    this.#seats.push(seat);
    worker.onmessage = (event) => this.#hear(seat, event.data);
    worker.onerror = (event) => {
      event.preventDefault?.();
      this.#replace(seat);
    };
    this.#watch(seat);
    worker.postMessage({ type: "start", module: this.#options.modules });
  }

  #watch(seat: Seat): void {
    if (seat.watch) clearTimeout(seat.watch);
    seat.watch = setTimeout(() => this.#replace(seat), SILENCE_MS);
  }

  #hear(seat: Seat, answer: Answer): void {
    if (answer.type === "progress") {
      if (seat.work?.id === answer.id) this.#watch(seat);
      return;
    }
    if (seat.watch) clearTimeout(seat.watch);
    seat.watch = null;
    if (answer.type === "ready") {
      seat.ready = true;
      this.#failedStarts = 0;
      this.#pump();
      return;
    }
    if (answer.type === "unable") {
      this.#problem = answer.error;
      this.#replace(seat);
      return;
    }
    const work = seat.work;
    if (!work || work.id !== answer.id) return;
    if (answer.type === "failed" && answer.fatal) {
      this.#replace(seat);
      return;
    }
    seat.work = null;
    work.entry.inFlight--;
    if (work.entry.live) {
      const { job } = work.entry;
      if (answer.type === "done") job.accept(work.task, answer.result as Result, answer.milliseconds);
      else job.fail(work.task, answer.error);
      this.#settle(work.entry);
    }
    this.#pump();
  }

  /** A dead worker's slice goes back to its job, and another worker takes its seat. */
  #replace(seat: Seat): void {
    if (this.#closed || !this.#seats.includes(seat)) return;
    this.#seats = this.#seats.filter((s) => s !== seat);
    this.#vacate(seat);
    const { work } = seat;
    if (work) {
      work.entry.inFlight--;
      const { task, tries, urgency } = work;
      if (tries < TRIES) work.entry.again.push({ task, tries: tries + 1, urgency });
      else if (work.entry.live) {
        const error: FrondError = {
          code: "worker-lost",
          message: "This could not be computed: its worker died.",
        };
        work.entry.job.fail(work.task, error);
        this.#settle(work.entry);
      }
    }
    if (seat.ready) this.#seat();
    else this.#startFailed();
    this.#pump();
  }

  #vacate(seat: Seat): void {
    if (seat.watch) clearTimeout(seat.watch);
    seat.worker.onmessage = null;
    seat.worker.onerror = null;
    seat.worker.terminate();
  }

  /** A worker that never came up is tried again once; when none is left, there are none to be had. */
  #startFailed(): void {
    this.#failedStarts++;
    if (this.#failedStarts <= 1) {
      this.#seat();
      return;
    }
    if (this.#seats.length > 0) {
      this.#report();
      return;
    }
    if (this.#closed) return;
    this.#closed = true;
    this.#entries.clear();
    this.#options.onUnavailable?.(this.#problem);
  }

  #pump(): void {
    for (const seat of this.#seats) {
      if (!seat.ready || seat.work) continue;
      const pick = this.#pick();
      if (!pick) break;
      const id = this.#nextId++;
      pick.entry.inFlight++;
      seat.work = { id, ...pick };
      this.#watch(seat);
      seat.worker.postMessage({ type: "run", id, name: pick.task.kind, args: pick.task });
    }
    this.#report();
  }

  #pick(): (Waiting & { entry: Entry }) | null {
    for (const entry of [...this.#entries.values()].sort((p, q) => urgencyOf(q) - urgencyOf(p))) {
      const waiting = entry.again.shift() ?? take(entry);
      if (waiting) return { entry, ...waiting };
      this.#settle(entry);
    }
    return null;
  }

  /** Ends a job that has nothing left to hand out and nothing under way. */
  #settle(entry: Entry): void {
    if (!entry.live || entry.inFlight > 0 || entry.again.length > 0) return;
    const waiting = take(entry);
    if (waiting) {
      entry.again.push(waiting);
      return;
    }
    entry.live = false;
    this.#entries.delete(entry.job.channel);
    entry.job.done?.();
  }

  #report(): void {
    this.#options.onChange?.({ count: this.#seats.filter((s) => s.ready).length, busy: this.busy });
  }
}

const urgencyOf = ({ job, again: [first] }: Entry): number => first?.urgency ?? job.priority();

/** The next slice of a job. The priority is asked before it: it may fall with the last slice of its kind. */
function take({ job }: Entry): Waiting | null {
  const urgency = job.priority();
  const task = job.next();
  return task && { task, tries: 1, urgency };
}

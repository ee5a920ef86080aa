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
  /** Slices that are handed out. */
  inFlight: number;
  /** Slices that were taken from the job and wait, as urgent as they were when they were taken. */
  again: Slice[];
}

interface Slice {
  entry: Entry;
  task: Task;
  tries: number;
  urgency: number;
  /** It is accepted or failed. */
  over: boolean;
}

/** A slice that a worker was given. */
interface Work {
  id: number;
  slice: Slice;
  /** It waited behind another when it was called back. The worker may have begun it since: then its answer counts. */
  recalled: boolean;
}

interface Seat {
  worker: WorkerLike<Modules>;
  ready: boolean;
  /** What the worker was given and has not answered, in order: the first is under way. */
  work: Work[];
  watch: ReturnType<typeof setTimeout> | null;
}

/** A worker that is silent for so long is taken for dead; a slice is some ten milliseconds. */
const SILENCE_MS = 20_000;
const TRIES = 3;
/** Slices that a worker has not answered, those that were called back among them. */
const MOST_AT_HAND = 3;
const LOST: FrondError = { code: "worker-lost", message: "This could not be computed: its worker died." };

/**
 * Hands slices of the most urgent jobs to workers. A job replaces the earlier one of its channel at once. Unlike a
 * lane, which keeps what it was asked in the order that it came, it chooses anew whenever a worker comes free. So that
 * none waits for the page between two slices, each has one more of the same channel at hand, which is taken back when
 * something more urgent comes, or when another worker has nothing to do.
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
    const entry: Entry = { job, live: true, inFlight: 0, again: [] };
    this.#entries.set(job.channel, entry);
    const urgency = urgencyOf(entry);
    for (const seat of this.#seats) {
      const [, ...behind] = seat.work;
      for (const work of behind) if (work.slice.urgency < urgency) this.#recall(seat, work);
    }
    this.#pump();
  }

  /** What is under way ends unheard; nothing more is handed out. */
  cancel(channel: Channel): void {
    const entry = this.#entries.get(channel);
    if (!entry) return;
    entry.live = false;
    this.#entries.delete(channel);
    for (const seat of this.#seats) {
      for (const work of [...seat.work]) if (work.slice.entry === entry) this.#recall(seat, work);
    }
    this.#report();
  }

  get busy(): boolean {
    return this.#entries.size > 0;
  }

  /** For tests: one worker dies as if the browser had killed it, the busiest first. */
  killOne(): void {
    const seat = this.#seats.find((s) => s.work.length > 0) ?? this.#seats[0];
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
    const seat: Seat = { worker, ready: false, work: [], watch: null };
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
    this.#unwatch(seat);
    seat.watch = setTimeout(() => this.#replace(seat), SILENCE_MS);
  }

  #unwatch(seat: Seat): void {
    if (seat.watch) clearTimeout(seat.watch);
    seat.watch = null;
  }

  #hear(seat: Seat, answer: Answer): void {
    if (answer.type === "progress") {
      if (seat.work.some(({ id }) => id === answer.id)) this.#watch(seat);
      return;
    }
    if (answer.type === "ready") {
      this.#unwatch(seat);
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
    if (answer.type === "failed" && answer.fatal) {
      this.#replace(seat);
      return;
    }
    const work = seat.work.find(({ id }) => id === answer.id);
    if (!work) return;
    seat.work = seat.work.filter((other) => other !== work);
    if (seat.work.length > 0) this.#watch(seat);
    else this.#unwatch(seat);
    const { slice, recalled } = work;
    if (answer.type === "done") {
      this.#end(slice, ({ job }) => job.accept(slice.task, answer.result as Result, answer.milliseconds));
    } else if (recalled) this.#giveBack(slice);
    else this.#end(slice, ({ job }) => job.fail(slice.task, answer.error));
    this.#pump();
  }

  /** A slice is answered, by whichever of its workers was first: the others need not begin it. */
  #end(slice: Slice, tell: (entry: Entry) => void): void {
    if (slice.over) return;
    slice.over = true;
    const { entry } = slice;
    entry.inFlight--;
    if (!entry.live) return;
    for (const seat of this.#seats) {
      for (const work of [...seat.work]) if (work.slice === slice) this.#recall(seat, work);
    }
    tell(entry);
    this.#settle(entry);
  }

  /** A slice that was handed out waits again, unless another worker has it as well. */
  #giveBack(slice: Slice): void {
    if (slice.over || this.#seats.some(({ work }) => work.some((other) => other.slice === slice))) return;
    this.#putBack(slice);
  }

  #recall(seat: Seat, work: Work): void {
    if (work.recalled) return;
    // What is under way keeps its worker until it ends.
    work.recalled = work !== seat.work[0];
    seat.worker.postMessage({ type: "stop", id: work.id });
  }

  /** A dead worker's slices go back to their jobs, and another worker takes its seat. */
  #replace(seat: Seat): void {
    if (this.#closed || !this.#seats.includes(seat)) return;
    this.#seats = this.#seats.filter((s) => s !== seat);
    this.#vacate(seat);
    for (const [place, { slice }] of [...seat.work.entries()].reverse()) {
      if (place > 0 || slice.tries++ < TRIES) this.#giveBack(slice);
      else this.#end(slice, ({ job }) => job.fail(slice.task, LOST));
    }
    if (seat.ready) this.#seat();
    else this.#startFailed();
    this.#pump();
  }

  #vacate(seat: Seat): void {
    this.#unwatch(seat);
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
      if (!seat.ready || seat.work.some(({ recalled }) => !recalled)) continue;
      const slice = this.#next();
      if (!slice) break;
      this.#give(seat, slice);
    }
    for (const seat of this.#seats) {
      const [under, more] = seat.work.filter(({ recalled }) => !recalled);
      // What was called back is still in its way until it answers.
      if (!under || more || seat.work.length >= MOST_AT_HAND) continue;
      const slice = this.#pick();
      if (!slice) break;
      // Whatever else there is to do goes to the first worker that is free, which may be another.
      if (slice.entry.job.channel === under.slice.entry.job.channel) this.#give(seat, slice);
      else this.#putBack(slice);
    }
    this.#report();
  }

  #give(seat: Seat, slice: Slice): void {
    const id = this.#nextId++;
    seat.work.push({ id, slice, recalled: false });
    if (!seat.watch) this.#watch(seat);
    seat.worker.postMessage({ type: "run", id, name: slice.task.kind, args: slice.task });
  }

  /** The most urgent slice for a worker that is free, be it one that waits behind another. */
  #next(): Slice | null {
    const slice = this.#pick();
    let best: { seat: Seat; work: Work } | null = null;
    for (const seat of this.#seats) {
      for (const work of behind(seat)) {
        const least = (best?.work.slice ?? slice)?.urgency ?? Number.NEGATIVE_INFINITY;
        if (work.slice.urgency > least) best = { seat, work };
      }
    }
    if (!best) return slice;
    if (slice) this.#putBack(slice);
    this.#recall(best.seat, best.work);
    return best.work.slice;
  }

  #putBack(slice: Slice): void {
    slice.entry.inFlight--;
    slice.entry.again.unshift(slice);
  }

  #pick(): Slice | null {
    for (const entry of [...this.#entries.values()].sort((p, q) => urgencyOf(q) - urgencyOf(p))) {
      const slice = entry.again.shift() ?? take(entry);
      if (slice) {
        entry.inFlight++;
        return slice;
      }
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

/**
 * What waits behind a slice that is wanted. What waits for nothing but slices that were called back is as good as under
 * way: two workers that have nothing else would take it from each other without end.
 */
const behind = ({ work }: Seat): Work[] => work.filter(({ recalled }) => !recalled).slice(1);

const urgencyOf = ({ job, again: [first] }: Entry): number => first?.urgency ?? job.priority();

/** The next slice of a job. The priority is asked before it: it may fall with the last slice of its kind. */
function take(entry: Entry): Slice | null {
  const urgency = entry.job.priority();
  const task = entry.job.next();
  return task && { entry, task, tries: 1, urgency, over: false };
}

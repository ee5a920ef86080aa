/** Where work is handed in: to a pool of workers, or, where there are none, to this thread. */
import { type ReadonlySignal, signal } from "@preact/signals";
import type { WorkerLike } from "../lanes/task";
import type { Pool } from "./pool";
import type { Channel, Job, Modules } from "./protocol";

let host: Pool | null = null;
let inline = false;
const early = new Map<Channel, Job>();

interface WorkersState {
  count: number;
  busy: boolean;
  available: boolean;
}

const state = signal<WorkersState>({ count: 0, busy: false, available: true });
export const workers: ReadonlySignal<WorkersState> = state;

/** Told what befalls the workers. */
export interface Watch {
  /** There are none to be had: the work is done on this thread. */
  inline(): void;
  /** Nor can it be done there. */
  failed(problem: unknown): void;
}

/** Goes up when everything has to be asked again, because the host of the work has changed. */
export const epoch = signal(0);

/** Asks for work. The latest job of a channel replaces the one before it; before the start it waits. */
export function submit(job: Job): void {
  if (host) host.submit(job);
  else {
    early.set(job.channel, job);
    state.value = { ...state.peek(), busy: true };
  }
}

export function cancel(channel: Channel): void {
  early.delete(channel);
  host?.cancel(channel);
}

/** All but one core, and at least two where there are two; more than eight gain nothing on a locus. */
function workerCount(cores: number): number {
  if (!(cores > 1)) return 1;
  return Math.min(8, Math.max(2, cores - 1));
}

/** What hands work out: the first picture does without it. */
export const fetchPool = () => import("./pool").then((module) => module.Pool);

/** Called once, after the first picture. */
export async function startEngine(
  modules: Modules,
  options: { workers: number | null },
  watch: Watch,
): Promise<void> {
  const Made = await fetchPool();
  if (host || inline) return;
  if (options.workers === 0 || typeof Worker === "undefined") {
    goInline(Made, modules, watch);
    return;
  }
  const pool = new Made({
    modules,
    count: options.workers ?? workerCount(navigator.hardwareConcurrency),
    spawn: () =>
      new Worker(new URL("./compute.worker.ts", import.meta.url), {
        type: "module",
        name: "frond",
      }) as WorkerLike<Modules>,
    onChange: (now) => {
      state.value = { ...now, available: true };
    },
    onUnavailable: () => {
      goInline(Made, modules, watch);
      epoch.value++;
    },
  });
  // Where workers cannot even be made, the pool has given up already, and another does its work.
  if (inline) return;
  host = pool;
  flush();
}

/** What is asked for until this thread has what it needs is kept, as before the start. */
function goInline(Made: typeof Pool, modules: Modules, watch: Watch): void {
  watch.inline();
  inline = true;
  host = null;
  state.value = { count: 0, busy: true, available: false };
  import("./inline").then(({ onPage }) => {
    host = new Made({
      modules,
      count: 1,
      spawn: onPage,
      onChange: ({ busy }) => {
        state.value = { count: 0, busy, available: false };
      },
      onUnavailable: watch.failed,
    });
    flush();
  }, watch.failed);
}

function flush(): void {
  const jobs = [...early.values()];
  early.clear();
  for (const job of jobs) host?.submit(job);
}

/** For tests: a worker dies in the middle of its work. */
export function killWorker(): void {
  host?.killOne();
}

/** About how long a slice may take: on the main thread it has to fit between two frames. */
export function sliceMilliseconds(): number {
  return state.peek().available ? 12 : 6;
}

/**
 * Workers that take jobs in turn. Pictures come before all else: one worker does nothing but draw, and what is asked
 * never takes all of the others.
 */

// The program of a worker as a text, which the build packs into the script.
import program from "./element.worker?program";
import type { Answer, Decided, Drawing, FromWorker, Job, Question, ToWorker } from "./protocol";
import { FrondError } from "./trouble";
import { trusted } from "./trusted";
import { work } from "./work";

/** The first only draws; the others do what there is. */
const WORKERS = 2;

interface Waiting {
  job: Job;
  /** Whether anybody still waits for it. */
  wanted(): boolean;
  resolve(result: unknown): void;
  reject(problem: unknown): void;
}

export class Pool {
  readonly #address: string;
  /** In the order in which they were started. */
  readonly #all: Worker[] = [];
  readonly #busy = new Map<Worker, Waiting>();
  readonly #drawings: Waiting[] = [];
  readonly #questions: Waiting[] = [];
  /** What the page itself does, where it may have no worker. */
  #own: Waiting | null = null;
  #closed = false;

  constructor(module: WebAssembly.Module) {
    this.#address = URL.createObjectURL(new Blob([program], { type: "text/javascript" }));
    for (let i = 0; i < WORKERS; i++) this.#start(module);
  }

  #start(module: WebAssembly.Module): void {
    try {
      const worker = new Worker(trusted(this.#address));
      worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#answered(worker, data);
      // A page that allows no such worker says so by this: then the page itself draws.
      worker.onerror = () => this.#lost(worker);
      worker.postMessage({ module } satisfies ToWorker);
      this.#all.push(worker);
    } catch {
      // Refused at once.
    }
  }

  draw(drawing: Drawing): Promise<Answer<{ kind: "draw"; drawing: Drawing }>> {
    return this.#queued(this.#drawings, { kind: "draw", drawing }, () => true);
  }

  /** What nobody waits for any more when its turn comes is not decided. */
  ask(question: Question, wanted: () => boolean): Promise<Decided> {
    return this.#queued(this.#questions, { kind: "ask", question }, wanted);
  }

  #queued<J extends Job>(queue: Waiting[], job: J, wanted: () => boolean): Promise<Answer<J>> {
    return new Promise((resolve, reject) => {
      queue.push({ job, wanted, resolve: resolve as Waiting["resolve"], reject });
      this.#go();
    });
  }

  #go(): void {
    if (this.#closed) return;
    if (this.#all.length === 0) {
      void this.#goWithout();
      return;
    }
    for (const worker of this.#all) {
      if (this.#busy.has(worker)) continue;
      const draws = worker === this.#all[0] && this.#all.length > 1;
      const waiting = this.#drawings.shift() ?? (draws ? undefined : this.#asked());
      if (!waiting) continue;
      this.#busy.set(worker, waiting);
      worker.postMessage({ job: waiting.job } satisfies ToWorker);
    }
  }

  /** The next question that somebody still waits for; a verdict comes before a path, which takes longer. */
  #asked(): Waiting | undefined {
    const gone = this.#questions.filter(({ wanted }) => !wanted());
    for (const waiting of gone) {
      this.#questions.splice(this.#questions.indexOf(waiting), 1);
      waiting.reject(cancelled());
    }
    const verdict = this.#questions.findIndex(({ job }) => job.kind === "ask" && !job.question.to);
    return this.#questions.splice(Math.max(0, verdict), 1)[0];
  }

  /** The page does it: what is drawn at once, what is asked one after the other, with pauses in between. */
  async #goWithout(): Promise<void> {
    for (const { job, resolve, reject } of this.#drawings.splice(0)) work(job).then(resolve, reject);
    if (this.#own) return;
    for (this.#own = this.#asked() ?? null; this.#own; this.#own = this.#asked() ?? null) {
      const { job, wanted, resolve, reject } = this.#own;
      const breathe = async () => {
        await new Promise((goOn) => setTimeout(goOn));
        if (this.#closed || !wanted()) throw cancelled();
      };
      await work(job, breathe).then(resolve, reject);
    }
  }

  #answered(worker: Worker, { result, failure }: FromWorker): void {
    const waiting = this.#busy.get(worker);
    this.#busy.delete(worker);
    if (failure) waiting?.reject(new FrondError(failure.code, failure.message));
    else waiting?.resolve(result);
    this.#go();
  }

  #lost(worker: Worker): void {
    this.#all.splice(this.#all.indexOf(worker), 1);
    const waiting = this.#busy.get(worker);
    this.#busy.delete(worker);
    if (waiting) (waiting.job.kind === "draw" ? this.#drawings : this.#questions).unshift(waiting);
    worker.terminate();
    this.#go();
  }

  /** Ends the workers; what they had to do is asked for again by whoever still wants it. */
  close(): void {
    this.#closed = true;
    for (const worker of this.#all) worker.terminate();
    URL.revokeObjectURL(this.#address);
    for (const { reject } of [...this.#busy.values(), ...this.#drawings, ...this.#questions])
      reject(cancelled());
  }
}

const cancelled = () => new FrondError("cancelled", "It is no longer shown.");

/**
 * Workers that take jobs in turn. One does nothing but draw, so that no question keeps a picture waiting. What has
 * shown nothing yet is drawn by all of them, before anything else.
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
  /** First pictures, and those of what is seen already. */
  readonly #firsts: Waiting[] = [];
  readonly #drawings: Waiting[] = [];
  readonly #questions: Waiting[] = [];
  /** The page itself is at work, since it may have no worker. */
  #going = false;
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

  draw(drawing: Drawing, first: boolean): Promise<Answer<{ kind: "draw"; drawing: Drawing }>> {
    return this.#queued(first ? this.#firsts : this.#drawings, { kind: "draw", drawing }, () => true);
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
      const asked = () => (draws ? undefined : this.#asked());
      const waiting = this.#firsts.shift() ?? asked() ?? this.#drawings.shift();
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

  /** The page does it, with pauses in which it answers; what is to be drawn comes before the rest of a question. */
  async #goWithout(): Promise<void> {
    if (this.#going) return;
    this.#going = true;
    const drawAll = async () => {
      await pause();
      const drawing = () => this.#firsts.shift() ?? this.#drawings.shift();
      for (let next = drawing(); next; next = drawing()) {
        await work(next.job).then(next.resolve, next.reject);
        await pause();
      }
    };
    for (;;) {
      await drawAll();
      const asked = this.#asked();
      if (!asked) break;
      const breathe = async () => {
        await drawAll();
        if (this.#closed || !asked.wanted()) throw cancelled();
      };
      await work(asked.job, breathe).then(asked.resolve, asked.reject);
    }
    this.#going = false;
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
    if (waiting) (waiting.job.kind === "draw" ? this.#firsts : this.#questions).unshift(waiting);
    worker.terminate();
    this.#go();
  }

  /** Ends the workers; what they had to do is asked for again by whoever still wants it. */
  close(): void {
    this.#closed = true;
    for (const worker of this.#all) worker.terminate();
    URL.revokeObjectURL(this.#address);
    for (const { reject } of [...this.#busy.values(), ...this.#firsts, ...this.#drawings, ...this.#questions])
      reject(cancelled());
  }
}

const pause = () => new Promise((goOn) => setTimeout(goOn));

const cancelled = () => new FrondError("cancelled", "It is no longer shown.");

import { toError } from "#wasm/error";
import type { Channel, Job, Result, Task } from "./protocol";

type Execute = (task: Task) => Promise<{ result: Result }>;

/** Stands in for the pool where workers cannot be had: slices on the main thread, with room to breathe between them. */
export class Inline {
  readonly #jobs = new Map<Channel, Job>();
  readonly #execute: Execute;
  readonly #onChange: (state: { count: number; busy: boolean }) => void;
  #running = false;

  constructor(execute: Execute, onChange: (state: { count: number; busy: boolean }) => void = () => {}) {
    this.#execute = execute;
    this.#onChange = onChange;
  }

  submit(job: Job): void {
    this.#jobs.set(job.channel, job);
    this.#report();
    void this.#run();
  }

  cancel(channel: Channel): void {
    this.#jobs.delete(channel);
    this.#report();
  }

  get busy(): boolean {
    return this.#jobs.size > 0;
  }

  killOne(): void {}

  async #run(): Promise<void> {
    if (this.#running) return;
    this.#running = true;
    for (;;) {
      // A macrotask between slices: input and frames go first.
      await new Promise((resolve) => setTimeout(resolve));
      const job = [...this.#jobs.values()].sort((p, q) => q.priority() - p.priority())[0];
      if (!job) break;
      const task = job.next();
      if (task) await this.#slice(job, task);
      else if (this.#jobs.get(job.channel) === job) {
        this.#jobs.delete(job.channel);
        job.done?.();
      }
    }
    this.#running = false;
    this.#report();
  }

  async #slice(job: Job, task: Task): Promise<void> {
    const started = performance.now();
    const live = () => this.#jobs.get(job.channel) === job;
    try {
      const { result } = await this.#execute(task);
      if (live()) job.accept(task, result, performance.now() - started);
    } catch (problem) {
      if (live()) job.fail(task, toError(problem));
    }
  }

  #report(): void {
    this.#onChange({ count: 0, busy: this.busy });
  }
}

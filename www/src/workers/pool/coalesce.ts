import type { Job } from "./protocol";

/**
 * For what is asked anew at every frame: the job under way is let finish, and of those that come meanwhile only the
 * last is started. Replacing each by the next would starve them all while something is dragged.
 */
export class Coalesce {
  readonly #submit: (job: Job) => void;
  #running: Job | null = null;
  #waiting: (() => Job) | null = null;

  constructor(submit: (job: Job) => void) {
    this.#submit = submit;
  }

  request(make: () => Job): void {
    if (this.#running) this.#waiting = make;
    else this.#start(make());
  }

  /** Forgets what is under way, for a host that is gone. */
  reset(): void {
    this.#running = null;
    this.#waiting = null;
  }

  #start(job: Job): void {
    this.#running = job;
    this.#submit({
      ...job,
      done: () => {
        job.done?.();
        if (this.#running !== job) return;
        this.#running = null;
        const next = this.#waiting;
        this.#waiting = null;
        if (next) this.#start(next());
      },
    });
  }
}

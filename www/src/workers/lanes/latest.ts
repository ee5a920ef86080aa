/** What is asked again and again: of two that would overlap only the later counts. */

/** Calls off the one before. */
export class Latest {
  #end: AbortController | null = null;

  /** The signal of the next; that of the last is aborted. */
  begin(): AbortSignal {
    this.stop();
    this.#end = new AbortController();
    return this.#end.signal;
  }

  stop(): void {
    this.#end?.abort();
    this.#end = null;
  }
}

/** Lets the one under way finish, and then does the last of those that came meanwhile: nothing starves in a drag. */
export class InTurn {
  #running = false;
  #next: (() => Promise<void>) | null = null;

  ask(work: () => Promise<void>): void {
    this.#next = work;
    if (!this.#running) void this.#run();
  }

  /** What waits is forgotten. */
  clear(): void {
    this.#next = null;
  }

  async #run(): Promise<void> {
    this.#running = true;
    while (this.#next) {
      const work = this.#next;
      this.#next = null;
      await work();
    }
    this.#running = false;
  }
}

/** Whether a task ended because something else was asked for. */
export function isStopped(problem: unknown): boolean {
  return typeof problem === "object" && problem !== null && "code" in problem && problem.code === "stopped";
}

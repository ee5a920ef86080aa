import type { Performer } from "./performer";
import type { Answer, WorkerLike } from "./task";

/** Stands in for a worker where none can be had. */
export class OnPage<M> implements WorkerLike<M> {
  onmessage: WorkerLike<M>["onmessage"] = null;
  onerror: WorkerLike<M>["onerror"] = null;
  readonly postMessage: WorkerLike<M>["postMessage"];

  constructor(performer: Performer<M>) {
    this.postMessage = performer((data) => this.onmessage?.({ data } as MessageEvent<Answer>));
  }

  terminate(): void {
    this.onmessage = null;
  }
}

/** How a picture is drawn: while it moves, or complete. */
export type Quality = "moving" | "complete";

interface Drawing<Request, Frame> {
  /** How many frames may be drawn at once. */
  lanes: number;
  draw: (request: Request, quality: Quality, lane: number) => Promise<Frame>;
  /** A frame is here that is newer than all before; null where it could not be drawn. */
  show: (frame: Frame | null, request: Request, quality: Quality) => void;
  /** A frame that is too late. */
  drop: (frame: Frame) => void;
}

/** What has not changed for so long has come to rest. */
const REST_MS = 90;

/**
 * Frames of what is asked for anew all the time: each lane draws the latest request that none has begun, and what comes
 * to rest is drawn complete. Frames are shown in the order in which they were asked for.
 */
export class FrameQueue<Request, Frame> {
  readonly #drawing: Drawing<Request, Frame>;
  readonly #busy: Set<number> = new Set();
  #wanted: { request: Request; number: number } | null = null;
  /** The latest request that is being drawn or was, in either way. */
  #begun: Record<Quality, number> = { moving: 0, complete: 0 };
  /** The latest that is shown. */
  #shown: Record<Quality, number> = { moving: 0, complete: 0 };
  #rest: ReturnType<typeof setTimeout> | undefined;
  #closed = false;

  constructor(drawing: Drawing<Request, Frame>) {
    this.#drawing = drawing;
  }

  ask(request: Request): void {
    this.#wanted = { request, number: (this.#wanted?.number ?? 0) + 1 };
    clearTimeout(this.#rest);
    this.#rest = undefined;
    this.#pump();
  }

  /** Whether the latest request is shown complete. */
  get complete(): boolean {
    return this.#wanted !== null && this.#shown.complete === this.#wanted.number;
  }

  close(): void {
    this.#closed = true;
    clearTimeout(this.#rest);
  }

  #pump(): void {
    const wanted = this.#wanted;
    if (this.#closed || !wanted) return;
    if (this.#begun.moving < wanted.number) this.#begin("moving");
    else if (this.#shown.moving === wanted.number && this.#begun.complete < wanted.number) {
      this.#rest ??= setTimeout(() => {
        this.#rest = undefined;
        this.#begin("complete");
      }, REST_MS);
    }
  }

  #begin(quality: Quality): void {
    const wanted = this.#wanted;
    const lane = Array.from({ length: this.#drawing.lanes }, (_, i) => i).find((i) => !this.#busy.has(i));
    if (lane === undefined || !wanted) return;
    this.#busy.add(lane);
    this.#begun[quality] = wanted.number;
    const { request, number } = wanted;
    this.#drawing.draw(request, quality, lane).then(
      (frame) => this.#end(lane, frame, request, number, quality),
      () => this.#end(lane, null, request, number, quality),
    );
  }

  #end(lane: number, frame: Frame | null, request: Request, number: number, quality: Quality): void {
    this.#busy.delete(lane);
    if (!this.#closed && this.#isNews(number, quality)) {
      this.#shown[quality] = number;
      this.#drawing.show(frame, request, quality);
    } else if (frame) this.#drawing.drop(frame);
    this.#pump();
  }

  /** A complete picture may be followed by a later one alone; so may one of what moves. */
  #isNews(number: number, quality: Quality): boolean {
    const { moving, complete } = this.#shown;
    return quality === "complete"
      ? number >= moving && number > complete
      : number > moving && number > complete;
  }
}

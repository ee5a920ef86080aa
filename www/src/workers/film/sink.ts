/** What takes frames one after the other and becomes a file. */
export interface Sink {
  /** Opaque RGBA, row 0 on top. It is not kept. */
  add(pixels: Uint8ClampedArray<ArrayBuffer>): Promise<void>;
  finish(): Promise<Uint8Array<ArrayBuffer>>;
  /** Leaves it unfinished. */
  drop(): Promise<void>;
}

export interface FrameSize {
  width: number;
  height: number;
  /** Frames a second. */
  fps: number;
}

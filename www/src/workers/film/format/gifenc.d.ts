/** As much of gifenc, which has no types of its own, as is used here. */
declare module "gifenc" {
  type Colour = number[];

  interface FrameOptions {
    /** Needed for the first frame; later ones without it use the first one's. */
    palette?: Colour[];
    /** Milliseconds. */
    delay?: number;
    /** 0: for ever. */
    repeat?: number;
    transparent?: boolean;
    transparentIndex?: number;
    /** 1: it stays, and the next frame is drawn over it. */
    dispose?: number;
  }

  interface Encoder {
    writeFrame(index: Uint8Array, width: number, height: number, options?: FrameOptions): void;
    finish(): void;
    bytes(): Uint8Array<ArrayBuffer>;
  }

  export function GIFEncoder(): Encoder;
  export function quantize(rgba: Uint8Array | Uint8ClampedArray, colours: number): Colour[];
}

import type { Easing } from "#geometry/pace";
import type { Repeat } from "#wasm/api";

/** A picture of a moment. */
export interface FramePixels {
  width: number;
  height: number;
  /** RGBA, straight alpha, row 0 on top. */
  data: Uint8ClampedArray<ArrayBuffer>;
  /** Milliseconds that it took a worker. */
  took: number;
}

/** How all frames of a film look. */
export interface FrameLook {
  width: number;
  height: number;
  /** Edges smoothed at four times the cost, where the subject leaves the choice. */
  smooth: boolean;
  /** What it is seen before, "#rrggbb": colours are to stand out from it. It is not part of the picture. */
  ground: string;
  /** Whether photographs lie in it, where there are some; missing: as by itself. */
  photograph?: boolean;
}

/** How often the subject is looked at for each pixel of a film. */
export type Samples = 1 | 4 | 16;

/** How a frame is drawn of which each pixel has so many samples: smooth is four, and twice as large four times. */
export const sampling = (samples: Samples): { smooth: boolean; drawn: 1 | 2 } => ({
  smooth: samples > 1,
  drawn: samples === 16 ? 2 : 1,
});

/** Draws the frames of one film. */
export interface Drawer {
  /** How many frames are drawn side by side. */
  readonly hands: number;
  /** Moments without a picture, so far: there the frame before stands. */
  readonly missing: number;
  /** The complete picture of a moment; null where it is that of the frame before. Asked for in the film's order. */
  frame(seconds: number, signal: AbortSignal): Promise<FramePixels | null>;
  /**
   * The same rows of the picture as if it were drawn whole, from `top` on: for pictures too large to be drawn at once.
   * Where it is missing there is only the whole.
   */
  strip?(seconds: number, rows: { top: number; count: number }, signal: AbortSignal): Promise<FramePixels>;
  end(): void;
}

/** On a square: 0 to 1 across, and down. */
export type Place = readonly [x: number, y: number];

/** A small map that may lie over the picture. */
export interface Inset {
  /** As it is now: a square, RGBA, with the way on it. */
  map(): { size: number; pixels: Uint8ClampedArray<ArrayBuffer>; way: readonly Place[] };
  /** Where a moment is on it. */
  at(seconds: number): Place;
}

/** Something that moves, as films know it. */
export interface Subject {
  id: string;
  /** As it is chosen among others. */
  label: string;
  /** What its files are called. */
  name: string;
  /** How long it takes once through. */
  seconds: number;
  /** Whether it may take as long as one likes. */
  anyLength: boolean;
  /** What it can do at its end, and what it does by itself. */
  loops: readonly Repeat[];
  loop: Repeat;
  /** How it goes by itself where it goes to and fro; null: it moves in steps, which have no speed. */
  easing: Easing | null;
  /** What is behind it on the stage, "#rrggbb". */
  ground: string;
  /** Whether smooth edges are a choice; else they are always smooth. */
  choosesSmooth: boolean;
  /** Whether photographs lie in it by itself; missing: there are none. */
  photograph?: boolean;
  /** What can be said of a moment, over the picture. */
  caption?: (seconds: number) => string;
  /** Where on a map it is, over the picture. */
  inset?: Inset;
  /** `alone`: one frame, now and again, while other things are done. */
  drawer(look: FrameLook, how?: { alone: boolean }): Drawer;
}

/** The same, drawn as if it took `seconds` once through. */
export function lasting(subject: Subject, seconds: number): Subject {
  const part = subject.seconds / seconds;
  const { caption, inset } = subject;
  return {
    ...subject,
    seconds,
    ...(caption ? { caption: (at: number) => caption(at * part) } : {}),
    ...(inset ? { inset: { ...inset, at: (at: number) => inset.at(at * part) } } : {}),
    drawer(look, how) {
      const drawer = subject.drawer(look, how);
      return {
        hands: drawer.hands,
        get missing() {
          return drawer.missing;
        },
        frame: (at, signal) => drawer.frame(at * part, signal),
        end: () => drawer.end(),
      };
    },
  };
}

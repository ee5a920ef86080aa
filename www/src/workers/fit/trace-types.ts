/**
 * From a file to outlines: what the tasks `openFile`, `mask`, `outline` and `closeFile` take and give.
 *
 * Pictures are seen at their working size (at most 4 megapixels; larger ones are made smaller while they are decoded),
 * x right and y down, row 0 on top, as they are painted on. Outlines have y up, from the lower left corner, run
 * counter-clockwise, and do not repeat the first point. A picture lives in one worker: ask the same lane for all of it.
 * What goes wrong is thrown as `{ code, message }`, and the message says what to try.
 */

/** Something that may be amiss, though there is a result. */
export interface TraceWarning {
  code: WarningCode;
  /** A sentence or two that say what to try. */
  message: string;
}

type WarningCode =
  /** It was made smaller for the work. */
  | "smaller"
  /** The shape is cut by the border of the picture: said of an outline, not of a mask. */
  | "touches-border"
  /** There are two leaves or more: one is taken, others can be picked. */
  | "several"
  /** All of it is of one light colour, or there is nothing in it that stands out. */
  | "blank"
  /** All of it is dark. */
  | "all-black"
  /** It is speckled all over, without a shape. */
  | "noise"
  /** The outline crosses itself. */
  | "crossing"
  /** What surrounds the picture, such as a frame, is left out. */
  | "surrounded"
  /** More points than are kept: so many were left out. */
  | "thinned"
  /** There are holes in it, which the outline leaves out. */
  | "holes"
  /** Lines without numbers, or with NaN, were left out; the message names them. */
  | "gaps"
  /** Numbers could be meant otherwise: the message says how commas and points were taken. */
  | "assumed"
  /** Lines that were open were closed. */
  | "closed"
  /** Scripts, pictures, texts or things from elsewhere in a drawing, which are never looked at. */
  | "ignored";

export interface OpenFileArgs {
  /** The file, read in the worker. Of a picture its first bytes are looked at before all of it. */
  file: Blob;
  name: string;
  /** What a table of numbers is to be taken for, where the first guess was wrong. */
  as?: "outlines" | "series";
}

export type Opened = OpenedPicture | OpenedOutlines | OpenedSeries;

export interface OpenedPicture {
  kind: "picture";
  /** What `mask`, `outline` and `closeFile` know it by. */
  id: number;
  name: string;
  /** The size that is worked on. */
  width: number;
  height: number;
  /** The size in the file. */
  original: { width: number; height: number };
  /** To be shown below the mask, at the working size. Close it when it is no longer shown. */
  bitmap: ImageBitmap;
  warnings: TraceWarning[];
}

export interface OpenedOutlines {
  kind: "outlines";
  name: string;
  format: "svg" | "csv" | "geojson";
  /** The largest first; never none. */
  outlines: ReadOutline[];
  warnings: TraceWarning[];
}

export interface ReadOutline {
  /** An id or a name in the file, or else what it was there: "path 2", "ring 1 of 3". */
  name: string;
  /** x0, y0, x1, y1, ..: three points or more, counter-clockwise, in the file's units with y up. */
  points: Float64Array<ArrayBuffer>;
  area: number;
  /** How often it crosses itself, 100 at most; null where that was too much to find out. */
  crossings: number | null;
}

export interface OpenedSeries {
  kind: "series";
  name: string;
  format: "csv";
  /** t0, x0, t1, x1, ..: three points or more, t growing. */
  points: Float64Array<ArrayBuffer>;
  warnings: TraceWarning[];
  /** Whether the same numbers make an outline, too: open it again with `as: "outlines"`. */
  orOutline: boolean;
}

/** A stroke of the brush. */
export interface Stroke {
  /** x0, y0, x1, y1, ..: where the brush went, in pixels of the working size; one point is a dab. */
  points: readonly number[];
  /** Half the brush's width in pixels. */
  radius: number;
  /** Whether it is leaf or not. Later strokes go over earlier ones. */
  what: "keep" | "remove";
  /** Whether it is said of these pixels and no others; else of what looks like them around, too. */
  exact?: boolean;
}

export interface MaskArgs {
  id: number;
  /** -1 to 1: less or more of the picture is taken for the leaf than was found by itself (0). */
  threshold: number;
  /** Whether stalks are taken off. */
  petiole: "keep" | "remove";
  /** Whether the leaf is what was taken for the ground. */
  invert?: boolean;
  /** All strokes so far. What is exact holds whatever the threshold is. */
  strokes: readonly Stroke[];
}

export interface Masked {
  width: number;
  height: number;
  /** 255 inside, 0 outside, row after row from the top. */
  mask: Uint8Array<ArrayBuffer>;
  /** Where the line was drawn, 0 to 255, and in what. */
  threshold: number;
  channel: "alpha" | "light" | "colour" | "saturation" | "greenness" | "green" | "red" | "blue" | "none";
  /** The largest first, 64 at most. */
  components: Component[];
  warnings: TraceWarning[];
}

export interface Component {
  /** In pixels. */
  area: number;
  /** Left, top, right and bottom in pixels; right and bottom are the first that are outside. */
  box: [left: number, top: number, right: number, bottom: number];
  /** A pixel of it, for a label or a press. */
  at: [x: number, y: number];
  touchesBorder: boolean;
}

export interface OutlineArgs {
  id: number;
  /** Its place in `components` of the last mask, from 0. */
  component: number;
}

export interface TracedOutline {
  /** x0, y0, x1, y1, ..: in pixels of the working size, y up, between pixels. At most 100,000 points. */
  points: Float64Array<ArrayBuffer>;
  area: number;
  length: number;
  warnings: TraceWarning[];
}

/** A picture that lies on its side or upside down. */
export interface TurnArgs {
  /** As it was opened, or turned before. */
  picture: OpenedPicture;
  /** Quarters of a turn, clockwise. */
  quarters: 1 | 2 | 3;
}

export interface CloseFileArgs {
  id: number;
}

/** Fits that a person keeps in this browser: the curve as a link holds it, and the outline that it was fitted to. */
import { type Database, database as shared } from "./database";
import { type Kept, Rows, soundFragment } from "./rows";

export interface KeptFit extends Kept {
  /** The fit alone in a document, as a link holds it. */
  fragment: string;
  /** Error in percent of the diagonal; null where there was no outline to measure it by. */
  rms: number | null;
  /** What it takes up in a link. */
  bytes: number;
  /** x0, y0, x1, y1, .. before it is smoothed; null where there is none. */
  outline: Float32Array<ArrayBuffer> | null;
  /** Of the leaf; null where it was not fitted to a photograph. */
  photograph: KeptPhotograph | null;
}

/** A small part of a photograph, with a leaf in it. */
export interface KeptPhotograph {
  /** A picture file. */
  blob: Blob;
  /** Where it lies in the plane of the fit: left, bottom, right, top. */
  box: readonly [x0: number, y0: number, x1: number, y1: number];
}

/** Fits that are kept besides those that are pinned. */
export const MOST_FITS = 40;
export const MOST_PINNED_FITS = 60;
/** Points of an outline that are kept. */
export const MOST_POINTS = 8192;
/** Pixels a side of a photograph, and bytes of its file. */
export const MOST_PIXELS = 512;
const MOST_BYTES = 1 << 21;

/** The fits of this browser. */
export class Fits extends Rows<KeptFit> {
  constructor(database: Database = shared) {
    super(database, { store: "fits", most: MOST_FITS, mostPinned: MOST_PINNED_FITS, sound });
  }
}

function sound(read: Record<string, unknown>): Omit<KeptFit, keyof Kept> | null {
  const { rms, bytes, outline, photograph } = read;
  const fragment = soundFragment(read["fragment"]);
  if (fragment === null || !isAmount(bytes) || !(rms === null || isAmount(rms))) return null;
  return {
    fragment,
    rms,
    bytes,
    outline: isOutline(outline) ? outline : null,
    photograph: soundPhotograph(photograph),
  };
}

function soundPhotograph(read: unknown): KeptPhotograph | null {
  if (typeof read !== "object" || read === null) return null;
  const { blob, box } = read as Record<string, unknown>;
  if (!(blob instanceof Blob) || blob.size === 0 || blob.size > MOST_BYTES) return null;
  if (!Array.isArray(box) || box.length !== 4 || !box.every(Number.isFinite)) return null;
  const [x0, y0, x1, y1] = box as [number, number, number, number];
  return x0 < x1 && y0 < y1 ? { blob, box: [x0, y0, x1, y1] } : null;
}

const isAmount = (read: unknown): read is number =>
  typeof read === "number" && Number.isFinite(read) && read >= 0;

function isOutline(read: unknown): read is Float32Array<ArrayBuffer> {
  if (!(read instanceof Float32Array) || read.length % 2 === 1) return false;
  return read.length >= 6 && read.length <= 2 * MOST_POINTS && read.every(Number.isFinite);
}

/** An outline as it is kept: evenly thinned to no more points than that. */
export function thinned(points: Float64Array): Float32Array<ArrayBuffer> {
  const count = points.length / 2;
  const kept = Math.min(count, MOST_POINTS);
  const thin = new Float32Array(2 * kept);
  for (let i = 0; i < kept; i++) {
    const from = Math.floor((i * count) / kept);
    thin[2 * i] = points[2 * from] ?? 0;
    thin[2 * i + 1] = points[2 * from + 1] ?? 0;
  }
  return thin;
}

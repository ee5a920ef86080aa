/** Boxes, and where the camera looks while a morph goes by: boxes at even times, between which it glides. */
import type { MapRow } from "#wasm/api";

/** A rectangle of the plane. */
export interface Box {
  x0: number;
  y0: number;
  x1: number;
  y1: number;
}

export type Track = readonly Box[];

export const UNIT: Box = { x0: 0, y0: 0, x1: 1, y1: 1 };
const KEYS = ["x0", "y0", "x1", "y1"] as const;
/** How much larger than its ends a morph may grow before the camera no longer follows. */
const GROWTH = 3;

/**
 * A calm track through the boxes of a morph at even times, null where it has none. Each look takes in the ones next to
 * it, and steps are evened out; moments at which the morph grows beyond measure do not count.
 */
export function calmTrack(looks: readonly (Box | null)[]): Track {
  const most = GROWTH * Math.max(0, ...[looks[0], looks.at(-1)].map((box) => (box ? diagonal(box) : 0)));
  const counted = filled(looks.map((box) => (box && !(most > 0 && diagonal(box) > most) ? box : null)));
  const last = counted.length - 1;
  const wide = counted.map((box, i) =>
    i === 0 || i === last ? box : union([counted[i - 1] ?? box, box, counted[i + 1] ?? box]),
  );
  return wide.map((box, i) => {
    if (i === 0 || i === last) return box;
    return blend(box, blend(wide[i - 1] ?? box, wide[i + 1] ?? box, 0.5), 0.5);
  });
}

/** A track that stands still. */
export function stillTrack(box: Box, looks: number): Track {
  return Array.from({ length: looks }, () => box);
}

/** The box of what a map makes of a box. */
export function imageOf({ x0, y0, x1, y1 }: Box, [a, b, c, d, e, f]: MapRow): Box {
  const xs = [a * x0 + b * y0, a * x0 + b * y1, a * x1 + b * y0, a * x1 + b * y1];
  const ys = [c * x0 + d * y0, c * x0 + d * y1, c * x1 + d * y0, c * x1 + d * y1];
  return {
    x0: Math.min(...xs) + e,
    y0: Math.min(...ys) + f,
    x1: Math.max(...xs) + e,
    y1: Math.max(...ys) + f,
  };
}

/** Rounds to short numbers beside a length: what is around a shape is known to no more. */
export function shortBeside(length: number): (x: number) => number {
  const step = 10 ** Math.floor(Math.log10(length > 0 ? length : 1) - 3);
  // By division, which gives the shortest digits; and no minus zero.
  return (x) => (step < 1 ? Math.round(x / step) / Math.round(1 / step) : Math.round(x / step) * step) || 0;
}

/** Where the camera is at the fraction `t` of the way. */
export function boxAt(track: Track, t: number): Box {
  const last = track.length - 1;
  const at = Math.min(1, Math.max(0, Number.isFinite(t) ? t : 0)) * Math.max(0, last);
  const i = Math.min(Math.floor(at), Math.max(0, last - 1));
  const from = track[i] ?? UNIT;
  return blend(from, track[i + 1] ?? from, at - i);
}

export function blendTracks(p: Track, q: Track, s: number): Track {
  return q.map((box, i) => blend(p[i] ?? box, box, s));
}

/** Whether two tracks show the same to the eye. */
export function sameTrack(p: Track, q: Track): boolean {
  return (
    p.length === q.length &&
    p.every((box, i) => {
      const other = q[i] ?? box;
      return KEYS.every((key) => Math.abs(box[key] - other[key]) <= 1e-6 * diagonal(other));
    })
  );
}

export function diagonal(box: Box): number {
  return Math.hypot(box.x1 - box.x0, box.y1 - box.y0);
}

export function union(boxes: readonly Box[]): Box {
  if (boxes.length === 0) return UNIT;
  return {
    x0: Math.min(...boxes.map((b) => b.x0)),
    y0: Math.min(...boxes.map((b) => b.y0)),
    x1: Math.max(...boxes.map((b) => b.x1)),
    y1: Math.max(...boxes.map((b) => b.y1)),
  };
}

/** Gaps take the box before them, and leading ones the first there is. */
function filled(looks: readonly (Box | null)[]): Box[] {
  let carried = looks.find((box) => box !== null) ?? UNIT;
  return looks.map((box) => {
    carried = box ?? carried;
    return carried;
  });
}

function blend(p: Box, q: Box, s: number): Box {
  const at = (key: keyof Box) => p[key] + s * (q[key] - p[key]);
  return { x0: at("x0"), y0: at("y0"), x1: at("x1"), y1: at("y1") };
}

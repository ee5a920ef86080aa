/** A map as turn, stretch, slant and move, and as six numbers; and the small changes that the editor offers. */
import type { MapRow } from "#wasm/api";

export interface Parts {
  /** Degrees, counter-clockwise, in (-180, 180]. */
  turn: number;
  /** How much longer the x axis becomes; never negative. */
  stretchX: number;
  /** The same for the y axis; negative where the map reflects. */
  stretchY: number;
  /** How far the tip of the unit y axis is pushed along the turned x axis. */
  slant: number;
  moveX: number;
  moveY: number;
}

const DEGREE = Math.PI / 180;
/** Rounds away the dust of sines and cosines, so that 90 degrees has zeros in its matrix. */
const clean = (x: number): number => {
  const near = Math.round(x * 1e15) / 1e15;
  return near === 0 ? 0 : Math.abs(near - x) < 1e-16 ? near : x;
};

/**
 * M = R(turn) [[stretchX, slant], [0, stretchY]]. A map that flattens the x axis has no turn of its own: it is
 * given 0, and its other column is told by slant and stretchY alone, so every map comes back from its parts.
 */
export function decompose([a, b, c, d, e, f]: MapRow): Parts {
  const stretchX = Math.hypot(a, c);
  const cos = stretchX > 0 ? a / stretchX : 1;
  const sin = stretchX > 0 ? c / stretchX : 0;
  const angle = stretchX > 0 ? Math.atan2(c, a) : 0;
  const turn = angle / DEGREE;
  return {
    turn: turn === -180 ? 180 : turn === 0 ? 0 : turn,
    stretchX,
    slant: clean(cos * b + sin * d),
    stretchY: clean(cos * d - sin * b),
    moveX: e,
    moveY: f,
  };
}

export function compose(parts: Parts): MapRow {
  const cos = clean(Math.cos(parts.turn * DEGREE));
  const sin = clean(Math.sin(parts.turn * DEGREE));
  const { stretchX: x, stretchY: y, slant: h } = parts;
  return [
    clean(cos * x),
    clean(cos * h - sin * y),
    clean(sin * x),
    clean(sin * h + cos * y),
    parts.moveX,
    parts.moveY,
  ];
}

/** The same piece, mirrored: the shape is turned over about the upright line through `centreX` before the map acts. */
export function reflect([a, b, c, d, e, f]: MapRow, centreX: number): MapRow {
  return [-a || 0, b, -c || 0, d, e + 2 * a * centreX, f + 2 * c * centreX];
}

/** First `inner`, then `outer`. */
export function after2(outer: MapRow, [a, b, c, d, e, f]: MapRow): MapRow {
  const [p, q, r, s, x, y] = outer;
  return [p * a + q * c, p * b + q * d, r * a + s * c, r * b + s * d, p * e + q * f + x, r * e + s * f + y];
}

export function imageOf([a, b, c, d, e, f]: MapRow, [x, y]: readonly [number, number]): [number, number] {
  return [a * x + b * y + e, c * x + d * y + f];
}

export function determinant([a, b, c, d]: MapRow): number {
  return a * d - b * c;
}

/** What a map does, in a few words, for a list: "×0.5, turned 45°". */
export function mapWords(map: MapRow): string {
  const det = determinant(map);
  const size = Math.sqrt(Math.abs(det));
  const { turn } = decompose(map);
  const words = [size < 1e-9 ? "flat" : `×${Number(size.toFixed(3))}`];
  const degrees = Math.round(turn * 10) / 10;
  if (degrees !== 0) words.push(`turned ${String(degrees).replace("-", "−")}°`);
  if (det < 0) words.push("mirrored");
  return words.join(", ");
}

/** A curve of the plane as its points and what each piece copies: what hands change, and what its maps follow from. */
import type { Graph } from "#wasm/api";

export type Point = [t: number, x: number, y: number];
export type Factor = [cx: number, cxy: number, cyx: number, cy: number];

interface Piece {
  /** What offsets are multiplied by. */
  factor: Factor;
  /** From which point to which it copies, from 0: backwards where the first is the larger. */
  span: [from: number, to: number];
}

export interface PlaneCurve {
  /** t grows; x and y are anything. */
  points: Point[];
  /** One fewer than points. */
  pieces: Piece[];
}

export type Place = readonly [x: number, y: number];

export const MOST_PIECES = 256;
/** The most maps of a system. */
export const MOST_MAPS = 64;
/** What an entry of a factor may say; whether it shrinks hangs on all four. */
export const MOST_ENTRY = 0.99;

/** How near a factor has to be to what turns a copy along its side, to be that one. */
const SAME = 1e-9;

const at = ({ points }: PlaneCurve, index: number): Place => {
  const [, x, y] = points[index] ?? [0, 0, 0];
  return [x, y];
};

/** What `interpolationCurve` is asked for. */
export function request({ points, pieces }: PlaneCurve): {
  points: Point[];
  options: { factors: Factor[]; spans: [number, number][] };
} {
  return {
    points: points.map(([...point]): Point => point),
    options: {
      factors: pieces.map(({ factor: [...row] }) => row),
      spans: pieces.map(({ span: [...span] }) => span),
    },
  };
}

/** By how much a factor lengthens at most: its largest singular value. */
export function norm([a, b, c, d]: Factor): number {
  // Half the lengths of what turns with a vector and of what turns against it.
  return (Math.hypot(a + d, c - b) + Math.hypot(a - d, b + c)) / 2;
}

/** Whether x answers to x alone and y to y (eq 8). */
export const isApart = ({ pieces }: PlaneCurve): boolean =>
  pieces.every(({ factor: [, cxy, cyx] }) => cxy === 0 && cyx === 0);

export const apart = (curve: PlaneCurve): PlaneCurve => ({
  ...curve,
  pieces: curve.pieces.map((piece) => {
    const [cx, , , cy] = piece.factor;
    return { ...piece, factor: [cx, 0, 0, cy] };
  }),
});

/**
 * The factor that turns what piece `index` copies along the side of the piece, and shortens it to that: the copy is a
 * similar one then. Null where what it copies ends where it begins.
 */
export function alongSide(curve: PlaneCurve, index: number, mirrored: boolean): Factor | null {
  const piece = curve.pieces[index];
  if (!piece) return null;
  const [from, to] = piece.span.map((end) => at(curve, end)) as [Place, Place];
  const [start, end] = [at(curve, index), at(curve, index + 1)];
  const [px, py] = [to[0] - from[0], to[1] - from[1]];
  const [qx, qy] = [end[0] - start[0], end[1] - start[1]];
  const square = px * px + py * py;
  if (square === 0) return null;
  const tidy = (x: number) => x / square + 0;
  // As complex numbers: q over p, or q over the conjugate of p.
  if (!mirrored) {
    const [re, im] = [tidy(qx * px + qy * py), tidy(qy * px - qx * py)];
    return [re, -im + 0, im, re];
  }
  const [re, im] = [tidy(qx * px - qy * py), tidy(qy * px + qx * py)];
  return [re, im, im, -re + 0];
}

/** Whether piece `index` lies along its side, and how; null where its factor is another one. */
export function sideOf(curve: PlaneCurve, index: number): "turned" | "mirrored" | null {
  const factor = curve.pieces[index]?.factor;
  if (!factor) return null;
  for (const mirrored of [false, true]) {
    const side = alongSide(curve, index, mirrored);
    if (side?.every((x, k) => Math.abs(x - (factor[k] ?? 0)) <= SAME))
      return mirrored ? "mirrored" : "turned";
  }
  return null;
}

/** A point somewhere else, in any order of x. Copies that lay along their sides go on to. */
export function withPlace(curve: PlaneCurve, index: number, [x, y]: Place): PlaneCurve {
  const old = curve.points[index];
  if (!old || !Number.isFinite(x) || !Number.isFinite(y) || (old[1] === x && old[2] === y)) return curve;
  const sides = curve.pieces.map((_, i) => sideOf(curve, i));
  const points = curve.points.map((point, i): Point => (i === index ? [point[0], x, y] : point));
  const moved = { ...curve, points };
  const pieces = moved.pieces.map((piece, i) => {
    const side = sides[i];
    const factor = side ? alongSide(moved, i, side === "mirrored") : null;
    return factor ? { ...piece, factor } : piece;
  });
  return { ...moved, pieces };
}

/** A point at another t: never past its neighbours. */
export function withTime(curve: PlaneCurve, index: number, t: number): PlaneCurve {
  const old = curve.points[index];
  if (!old || !Number.isFinite(t)) return curve;
  const long = (curve.points.at(-1)?.[0] ?? 1) - (curve.points[0]?.[0] ?? 0);
  const low = (curve.points[index - 1]?.[0] ?? Number.NEGATIVE_INFINITY) + 1e-4 * long;
  const high = (curve.points[index + 1]?.[0] ?? Number.POSITIVE_INFINITY) - 1e-4 * long;
  const next = Math.min(high, Math.max(low, t));
  const points = curve.points.map((point, i): Point => (i === index ? [next, point[1], point[2]] : point));
  return { ...curve, points };
}

export function withPiece(curve: PlaneCurve, index: number, change: Partial<Piece>): PlaneCurve {
  return {
    ...curve,
    pieces: curve.pieces.map((piece, i) => (i === index ? { ...piece, ...change } : piece)),
  };
}

/** A point more, in the middle of a piece, at a place of the curve; both halves copy what the piece copied. */
export function withPointIn(curve: PlaneCurve, piece: number, place: Place): PlaneCurve {
  const [from, to] = [curve.points[piece], curve.points[piece + 1]];
  const old = curve.pieces[piece];
  if (!from || !to || !old || curve.pieces.length >= MOST_PIECES) return curve;
  const points = [...curve.points];
  points.splice(piece + 1, 0, [(from[0] + to[0]) / 2, ...place]);
  const shift = (end: number) => (end > piece ? end + 1 : end);
  const pieces = curve.pieces.map(
    (one): Piece => ({ ...one, span: [shift(one.span[0]), shift(one.span[1])] }),
  );
  const half = pieces[piece] ?? old;
  pieces.splice(piece, 0, { ...half });
  return { points, pieces };
}

/** Without a point that is not an end. What ended there ends at its neighbour, outwards. */
export function withoutPoint(curve: PlaneCurve, index: number): PlaneCurve {
  const last = curve.points.length - 1;
  if (index <= 0 || index >= last || last < 3) return curve;
  const points = curve.points.filter((_, i) => i !== index);
  const time = (i: number) => points[i]?.[0] ?? 0;
  const pieces = curve.pieces
    .filter((_, i) => i !== index)
    .map((piece, i): Piece => {
      const [from, to] = piece.span;
      const back = from > to;
      const low = Math.min(from, to) - (Math.min(from, to) >= index ? 1 : 0);
      const high = Math.max(from, to) - (Math.max(from, to) > index ? 1 : 0);
      // What became too long for what it copies copies all.
      const fits = time(high) - time(low) > (time(i + 1) - time(i)) * (1 + 1e-6);
      const [start, end] = fits ? [low, high] : [0, last - 1];
      return { ...piece, span: back ? [end, start] : [start, end] };
    });
  return { points, pieces };
}

/** A graph as a curve of the plane: x is t, and y what its height was. Its pieces have to copy from point to point. */
export function fromGraph({ kind, pieces }: Graph, height: (t: number) => number): PlaneCurve | null {
  if (kind === "pfif") return null;
  const ends = pieces.map(({ map: [a, , , d], domain }) =>
    domain.map((t) => a * t + d).sort((p, q) => p - q),
  );
  const times = [...ends.map(([from]) => from ?? 0), ends.at(-1)?.[1] ?? 1];
  const long = (times.at(-1) ?? 1) - (times[0] ?? 0);
  const near = (t: number) => times.findIndex((time) => Math.abs(time - t) <= 1e-7 * long);
  const rows = pieces.map(({ map: [a, , c], domain }): Piece => {
    const [from, to] = domain.map(near) as [number, number];
    return { factor: [0, 0, 0, c], span: a < 0 ? [to, from] : [from, to] };
  });
  if (rows.some(({ span }) => span.includes(-1))) return null;
  const tidy = (x: number) => Number(x.toPrecision(13));
  return { points: times.map((t): Point => [tidy(t), tidy(t), tidy(height(t))]), pieces: rows };
}

/** The maps [a, b, c, d, e, f] of the plane that alone make the curve; null where they need its t, too. */
export function plainMaps(curve: {
  pieces: readonly { map: readonly number[]; domain: readonly number[] }[];
}): [number, number, number, number, number, number][] | null {
  const last = curve.pieces.at(-1)?.domain[1];
  const first = curve.pieces[0]?.domain[0];
  const rows: [number, number, number, number, number, number][] = [];
  for (const { map, domain } of curve.pieces) {
    const [, bx = 0, by = 0, cx = 0, cxy = 0, cyx = 0, cy = 0, , ex = 0, ey = 0] = map;
    const size = Math.max(1e-12, ...map.map(Math.abs));
    const whole = domain[0] === first && domain[1] === last;
    if (!whole || Math.max(Math.abs(bx), Math.abs(by)) > 1e-9 * size) return null;
    rows.push([cx, cxy, cyx, cy, ex, ey]);
  }
  return rows;
}

// A curve of the plane as a word of the document: "t,x,y;..:cx,cxy,cyx,cy,from,to;..".

export const toWord = ({ points, pieces }: PlaneCurve): string =>
  [points, pieces.map(({ factor, span }) => [...factor, ...span])]
    .map((rows) => rows.map((row) => row.map(plain).join(",")).join(";"))
    .join(":");

/** No plus in exponents, which a link would have to escape. */
const plain = (x: number) => String(x + 0).replace("+", "");

/** The curve of a word; null where it is none. Whether its factors shrink is not asked here. */
export function fromWord(word: string): PlaneCurve | null {
  const [points, pieces, ...rest] = word.split(":").map(rows);
  const count = pieces?.length ?? 0;
  if (!points || !pieces || rest.length > 0 || count < 1 || count > MOST_PIECES) return null;
  const isPoint = (row: number[]): row is Point => row.length === 3;
  const ends = (row: number[]) =>
    row.slice(4).every((end) => Number.isInteger(end) && end >= 0 && end <= count);
  if (points.length !== count + 1 || !points.every(isPoint)) return null;
  if (!pieces.every((row) => row.length === 6 && ends(row))) return null;
  return {
    points,
    pieces: pieces.map(([cx = 0, cxy = 0, cyx = 0, cy = 0, from = 0, to = 0]) => {
      const factor: Factor = [cx, cxy, cyx, cy];
      return { factor, span: [from, to] };
    }),
  };
}

function rows(text: string): number[][] | null {
  const list = text.split(";").map((row) => row.split(",").map((x) => (x === "" ? Number.NaN : Number(x))));
  return list.every((row) => row.every(Number.isFinite)) ? list : null;
}

/** A curve through three points of the plane, made of two copies of itself (Cochran, Hart & Flynn, section 2.4). */
import { wordsOf } from "#document/notice";
import { toWord } from "#tools/fit/plane/model/curve";
import type { PlaneGraph } from "#wasm/api";
import { rough } from "#wasm/curve";

export type Factor = readonly [cx: number, cxy: number, cyx: number, cy: number];
export type Place = readonly [x: number, y: number];

/** The points and the factors that the page begins with. */
export const PLACES: readonly Place[] = [
  [0, 0],
  [0.5, 0.45],
  [1, 0],
];
export const FACTORS: readonly Factor[] = [
  [0.5, 0.45, 0.45, -0.5],
  [0.5, -0.45, -0.45, -0.5],
];

/** The t of the three points. */
export const TIMES = [0, 0.5, 1] as const;

/** The curve, or why there is none. */
export function curveThrough(
  places: readonly Place[],
  factors: readonly Factor[],
  reflected: readonly boolean[],
): PlaneGraph | string {
  try {
    return rough.interpolationCurve(
      places.map(([x, y], i): [number, number, number] => [TIMES[i] ?? 1, x, y]),
      { factors: factors.map(([...row]) => row), reflected: [...reflected] },
    );
  } catch (problem) {
    return wordsOf(problem);
  }
}

/** It as a document has it. */
export const wordOf = (
  places: readonly Place[],
  factors: readonly Factor[],
  reflected: readonly boolean[],
): string =>
  toWord({
    points: places.map(([x, y], i) => [TIMES[i] ?? 1, x, y]),
    pieces: factors.map(([...factor], i) => ({ factor, span: reflected[i] ? [2, 0] : [0, 2] })),
  });

/** What of a factor stays where x and y are apart (eq 8). */
export const apart = ([cx, , , cy]: Factor): Factor => [cx, 0, 0, cy];

export interface Drawn {
  /** x0, y0, x1, y1, .. of each piece. */
  pieces: Float64Array[];
  /** t and x, and t and y. */
  x: Float64Array;
  y: Float64Array;
}

/** Its polyline, and that of each coordinate over t. */
export function drawn(curve: PlaneGraph): Drawn {
  const flat = rough.sampleInterpolationCurve(curve, { tolerance: 0.006, most: 20_000 });
  const count = flat.length / 3;
  const pick = (from: number, to: number, p: number, q: number) => {
    const list = new Float64Array(2 * Math.max(0, to - from));
    for (let i = from; i < to; i++) {
      list[2 * (i - from)] = flat[3 * i + p] ?? 0;
      list[2 * (i - from) + 1] = flat[3 * i + q] ?? 0;
    }
    return list;
  };
  let middle = 0;
  while (middle < count && (flat[3 * middle] ?? 0) < TIMES[1]) middle++;
  return {
    pieces: [pick(0, Math.min(count, middle + 1), 1, 2), pick(middle, count, 1, 2)],
    x: pick(0, count, 0, 1),
    y: pick(0, count, 0, 2),
  };
}

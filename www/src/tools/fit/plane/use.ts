/** A curve of the plane becomes a shape like any other: a system of maps where it is one, else an outline. */
import { tellReplaced } from "#document/curve/replaced";
import { useCurve as takeCurve, takeMaps, type Use } from "#document/fit";
import { notify, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import type { CurveShape, Shape } from "#wasm/api";
import { rough } from "#wasm/curve";
import * as messages from "../messages";
import { MOST_MAPS, plainMaps } from "./model/curve";
import { maps } from "./model/document";

/** The most corners of an outline: as many as a link holds with ease. */
const MOST_CORNERS = 1024;
const NAME = messages.curvePlane;

/** The maps of the plane that make it; null where its maps need t. */
export function systemOf(): Shape | null {
  const now = maps.peek();
  const rows = now && plainMaps(now);
  return rows && rows.length <= MOST_MAPS ? { name: NAME, maps: rows } : null;
}

/** It as a closed outline. */
export function outlineOf(): CurveShape | null {
  const now = maps.peek();
  if (!now) return null;
  const line = rough.sampleInterpolationCurve(now, { tolerance: 0, most: MOST_CORNERS });
  return { name: NAME, curve: polygonOf(line) };
}

/** The polygon of t0, x0, y0, t1, .., without corners that are there twice. */
export function polygonOf(line: ArrayLike<number>): CurveShape["curve"] {
  const knots: [number, number][] = [];
  for (let i = 0; i + 2 < line.length; i += 3) {
    const [x, y] = [line[i + 1] ?? 0, line[i + 2] ?? 0];
    const last = knots.at(-1);
    if (!last || last[0] !== x || last[1] !== y) knots.push([x, y]);
  }
  const [first, last] = [knots[0], knots.at(-1)];
  if (first && last && knots.length > 1 && first[0] === last[0] && first[1] === last[1]) knots.pop();
  return { knots, edges: knots.map(() => null) };
}

export const takeSystem = (shape: Shape, to: Use): void => takeMaps(shape, to);

export function takeOutline(shape: CurveShape, to: Use): void {
  try {
    const partner = rough.curvePresets().find(({ id }) => id === "sugar-maple") ?? rough.curvePresets()[0];
    if (!partner) throw new Error(messages.thereNoOtherShape);
    const before = scene.peek();
    takeCurve(shape, partner, to);
    tellReplaced(before, to === "b" ? "b" : "a");
  } catch (problem) {
    notify({ kind: "error", text: messages.curveNotUsed(wordsOf(problem)) });
  }
}

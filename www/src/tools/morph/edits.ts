/** What the panel does to the document, as functions from scene to scene. */

import { locusView } from "#document/morph";
import { pause, setT } from "#document/playback";
import { replace, scene } from "#document/scene";
import type { MapRow, PathPoint, Scene, Shape } from "#wasm/api";

export type End = "a" | "b";

export const other = (end: End): End => (end === "a" ? "b" : "a");

/** The ends as people call them. */
export const nameOf = (end: End): string => (end === "a" ? "A" : "B");

export const MOST_MAPS = 64;
export const MOST_POINTS = 64;

/** A shape of the gallery, or from elsewhere, at one end. */
export function choose(scene: Scene, end: End, shape: Shape): Scene {
  return withShape(scene, end, shape);
}

/** The shape of one end at both. */
export function asBoth(scene: Scene, end: End): Scene {
  return withShape(scene, other(end), scene[end]);
}

/** Another shape: which map becomes which is asked anew. */
export function withShape(scene: Scene, end: End, shape: Shape): Scene {
  return { ...scene, [end]: shape, correspondence: [], turns: [] };
}

/** The same morph, run from the other side. */
export function swap(scene: Scene): Scene {
  const back = ([u, v, w]: PathPoint): PathPoint => (w ? [1 - u, 1 - v, -w] : [1 - u, 1 - v]);
  const points = scene.path.points.map(back).reverse();
  const correspondence: number[] = [];
  const turns: number[] = [];
  scene.correspondence.forEach((to, from) => {
    correspondence[to] = from;
  });
  scene.turns.forEach((turn, from) => {
    turns[scene.correspondence[from] ?? from] = turn === 0 ? 0 : -turn;
  });
  return {
    ...scene,
    a: scene.b,
    b: scene.a,
    path: { ...scene.path, points },
    t: 1 - scene.t,
    correspondence,
    turns,
  };
}

/** Each map turns by so many whole turns more. No turn at all is what an empty list stands for. */
export function turnedFurther(scene: Scene, by: readonly number[]): Scene {
  const turns = by.map((turn, i) => turn + ((scene.turns.length === by.length && scene.turns[i]) || 0));
  return { ...scene, turns: turns.every((turn) => turn === 0) ? [] : turns };
}

/** Waypoints as the hand left them: the path is drawn from now on. */
export function setPoints(scene: Scene, points: PathPoint[]): Scene {
  return { ...scene, path: { kind: "drawn", points: points.slice(0, MOST_POINTS) } };
}

/** Pairs, numbered from 1, whose two maps reflect oppositely: on the way such a map must become flat. */
export function flatPairs(
  from: readonly MapRow[],
  to: readonly MapRow[],
  correspondence: readonly number[],
): number[] {
  const det = (m: MapRow | undefined) => (m === undefined ? 0 : m[0] * m[3] - m[1] * m[2]);
  const found: number[] = [];
  from.forEach((map, i) => {
    if (det(map) * det(to[correspondence[i] ?? i]) < 0) found.push(i + 1);
  });
  return found;
}

/** Moves in time by hand: what plays stops, and the picture is on the path again. */
export function scrubTo(t: number): void {
  pause();
  leavePoint();
  setT(Math.min(1, Math.max(0, t)));
}

/** A point that was picked off the path is let go; another family's plane gives way to the morph's. */
function leavePoint(): void {
  const { at, ...view } = locusView.peek();
  if (at === undefined && view.family === "morph") return;
  const { locus: _, ...rest } = scene.peek();
  replace(view.family === "morph" ? { ...rest, locus: view } : rest);
}

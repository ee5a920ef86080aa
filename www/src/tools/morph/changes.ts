/** What the panel does to the document, as functions from scene to scene. */

import { sameMaps } from "#geometry/maps/same-maps";
import type { Candidate, MapRow, PathPoint, Route, Scene, Shape } from "#wasm/api";

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

/** Another name for the shape of one end. It is no longer the gallery's, whose names are its own. */
export function rename(scene: Scene, end: End, name: string): Scene {
  return { ...scene, [end]: { name, maps: scene[end].maps } };
}

/** The shape of one end at both. */
export function asBoth(scene: Scene, end: End): Scene {
  return withShape(scene, other(end), scene[end]);
}

/** Another shape: which map becomes which is asked anew. */
function withShape(scene: Scene, end: End, shape: Shape): Scene {
  return { ...scene, [end]: shape, correspondence: [], turns: [] };
}

/**
 * Other maps at one end. The shape keeps its name, and is no longer the gallery's. Which map becomes which is told by
 * number, so it holds only while there are as many maps as before.
 */
export function setMaps(scene: Scene, end: End, maps: MapRow[]): Scene {
  const shape: Shape = { name: scene[end].name, maps };
  if (maps.length !== scene[end].maps.length) return withShape(scene, end, shape);
  return { ...scene, [end]: shape };
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

/** Way points as the hand left them: the path is drawn from now on. */
export function setPoints(scene: Scene, points: PathPoint[]): Scene {
  return { ...scene, path: { kind: "drawn", points: points.slice(0, MOST_POINTS) } };
}

/** Lists that say what is so anyway are left out of the document. */
function matched({ correspondence, turns }: Pick<Candidate, "correspondence" | "turns">) {
  return {
    correspondence: correspondence.every((to, from) => to === from) ? [] : correspondence,
    turns: turns.every((turn) => turn === 0) ? [] : turns,
  };
}

/** Another way to match, with the path that was found for it. */
export function takeMatching(
  scene: Scene,
  candidate: Pick<Candidate, "correspondence" | "turns">,
  points: PathPoint[],
): Scene {
  return { ...scene, ...matched(candidate), path: { kind: "auto", points: points.slice(0, MOST_POINTS) } };
}

/** A way across: the shapes stay what they are, even where other maps make them. The path is planned anew. */
export function takeRoute(scene: Scene, route: Route): Scene {
  const made = (shape: Shape, maps: MapRow[]): Shape =>
    sameMaps(shape.maps, maps) ? shape : { name: shape.name, maps };
  return {
    ...scene,
    ...matched(route),
    a: made(scene.a, route.from),
    b: made(scene.b, route.to),
    mode: route.mode ?? scene.mode,
    path: { kind: route.kind === "joints" ? "straight" : "auto", points: [] },
  };
}

/** A way that was found, with its path: all at once, and one step to undo. */
export function takeWay(scene: Scene, way: Route | null, points: PathPoint[]): Scene {
  const path: Scene["path"] =
    way?.kind === "joints"
      ? { kind: "straight", points: [] }
      : { kind: "auto", points: points.slice(0, MOST_POINTS) };
  return way === null ? { ...scene, path } : { ...takeRoute(scene, way), path };
}

/** Whether the document matches the maps like this. */
export function isMatched(
  scene: Pick<Scene, "correspondence" | "turns">,
  candidate: Pick<Candidate, "correspondence" | "turns">,
): boolean {
  const is = matched(candidate);
  const now = matched(scene);
  const same = (p: readonly number[], q: readonly number[]) =>
    p.length === q.length && p.every((x, i) => x === q[i]);
  return same(is.correspondence, now.correspondence) && same(is.turns, now.turns);
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

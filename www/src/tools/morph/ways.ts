/** How what was found becomes the document's: ways to match, and ways across, as functions from scene to scene. */
import { remade } from "#geometry/maps/weighted";
import type { Candidate, PathPoint, Route, Scene } from "#wasm/api";
import { MOST_POINTS } from "./edits";
import { noteMatched } from "./shapes/matched";

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
  return {
    ...scene,
    ...matched(route),
    a: noteMatched(scene.a, remade(scene.a, route.from, route.fromProbabilities)),
    b: noteMatched(scene.b, remade(scene.b, route.to, route.toProbabilities)),
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

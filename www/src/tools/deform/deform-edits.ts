/** What the panel does to the document, as functions from document to document. */

import { withoutCurves } from "#document/curve/changes";
import { MOST_KEYS, momentOf, SAME } from "#document/deform/keys";
import { inBox } from "#geometry/mesh";
import type { Deformation, MapRow, Scene, Shape } from "#wasm/api";

export { inBox } from "#geometry/mesh";

/** The largest detail where nothing says how deep memory allows it. */
export const DEEPEST = 12;
export const MOST_ROUGHNESS = 1.5;

/** A shape, with the mesh around it: the moment goes to the start, where the shape is. */
export function choose(scene: Scene, shape: Shape, box: Deformation["box"]): Scene {
  const chosen: Scene = { ...withoutCurves(onPath(scene)), a: shape, t: 0, correspondence: [], turns: [] };
  return scene.deform ? { ...chosen, deform: inBox({ ...scene.deform, subject: "shape" }, box) } : chosen;
}

/** A point that was picked off the morph's path, or in another family, is let go: the picture is the morph's again. */
export function onPath(scene: Scene): Scene {
  if (!scene.locus || (scene.locus.at === undefined && scene.locus.family === "morph")) return scene;
  const { locus, ...rest } = scene;
  const { at: _, ...view } = locus;
  return view.family === "morph" ? { ...rest, locus: view } : rest;
}

/** Another detail. The locality that was wished for stays as far as there is room for it. */
export function withDetail(deformation: Deformation, ke: number, wished: number): Deformation {
  return { ...deformation, ke, kb: Math.min(wished, ke) };
}

export function withLocality(deformation: Deformation, kb: number): Deformation {
  return { ...deformation, kb: Math.min(Math.max(0, kb), deformation.ke) };
}

/** Roughness at the four corners, or the mean of them everywhere. */
export function withCorners(deformation: Deformation, apart: boolean): Deformation {
  const { delta } = deformation;
  if (apart === Array.isArray(delta)) return deformation;
  if (!Array.isArray(delta)) return { ...deformation, delta: [delta, delta, delta, delta] };
  const mean = delta.reduce((sum, d) => sum + d, 0) / 4;
  return { ...deformation, delta: Number(mean.toFixed(3)) };
}

/** How much a map stretches at most: its operator norm. */
export function ratioOf([a, b, c, d]: MapRow): number {
  const sum = a * a + b * b + c * c + d * d;
  const det = a * d - b * c;
  return Math.sqrt(Math.max(0, (sum + Math.sqrt(Math.max(0, sum * sum - 4 * det * det))) / 2));
}

/** The roughness from which on the small parts answer more than they are large. */
export function roughFrom(maps: readonly MapRow[]): number {
  return Math.max(0, ...maps.map(ratioOf));
}

/** A key moved in time: it stays between its neighbours, and off them. */
export function withKeyAt(deformation: Deformation, index: number, at: number): Deformation {
  const { keys, loop } = deformation;
  const key = keys[index];
  if (!key || !Number.isFinite(at)) return deformation;
  const least = (keys[index - 1]?.at ?? -2 * SAME) + 2 * SAME;
  const most = (keys[index + 1]?.at ?? (loop ? 1 : 1 + 2 * SAME)) - 2 * SAME;
  const to = Number(Math.min(most, Math.max(least, at)).toFixed(4));
  if (to === key.at) return deformation;
  return { ...deformation, phase: to, keys: keys.map((k, i) => (i === index ? { ...k, at: to } : k)) };
}

/** Without one key; the last one cannot go. */
export function withoutKey(deformation: Deformation, index: number): Deformation {
  if (deformation.keys.length < 2 || !deformation.keys[index]) return deformation;
  return { ...deformation, keys: deformation.keys.filter((_, i) => i !== index) };
}

/** With one more key, of these moves. The same where there is one at this moment already, or no room. */
export function withKey(deformation: Deformation, at: number, moves: readonly number[]): Deformation {
  const { keys } = deformation;
  const moment = momentOf(deformation, at);
  if (keys.length >= MOST_KEYS || keys.some((key) => Math.abs(key.at - moment) <= SAME)) return deformation;
  const made = { at: moment, moves: [...moves] };
  return { ...deformation, phase: moment, keys: [...keys, made].sort((p, q) => p.at - q.at) };
}

/** Whether it goes round: what lies at the very end then lies at the start. */
export function withLoop(deformation: Deformation, loop: boolean): Deformation {
  if (loop === deformation.loop) return deformation;
  const last = deformation.keys.at(-1);
  const crowded = loop && deformation.keys.length > 1 && last !== undefined && last.at > 1 - SAME;
  const first = deformation.keys[0];
  if (!crowded) return { ...deformation, loop };
  // The start has a key of its own, or else takes the last one's.
  const rest = deformation.keys.slice(0, -1);
  const keys = first && first.at <= SAME ? rest : [{ ...last, at: 0 }, ...rest];
  return { ...deformation, loop, keys };
}

/** Whether both ends are the same: then there is no morph to speak of. */
export function sameShapes(a: Scene["a"], b: Scene["b"]): boolean {
  return a === b || (a.maps.length === b.maps.length && a.maps.every((map, i) => sameMap(map, b.maps[i])));
}

function sameMap(p: MapRow, q: MapRow | undefined): boolean {
  return q !== undefined && p.every((x, i) => x === q[i]);
}

/** Whether two boxes are the same to the eye. */
export function sameBox(p: Deformation["box"], q: Deformation["box"]): boolean {
  const slight = 1e-3 * Math.max(q[2] - q[0], q[3] - q[1]);
  return p.every((side, i) => Math.abs(side - (q[i] ?? side)) <= slight);
}

/** Whether nothing is moved at any time. */
export function isAtRest({ keys }: Pick<Deformation, "keys">): boolean {
  return keys.every(({ moves }) => moves.every((x) => x === 0));
}

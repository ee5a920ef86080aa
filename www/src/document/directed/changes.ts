/** What is done to a document that holds graph-directed shapes, as functions from scene to scene. */
import type { DirectedShape, HalfTurns, Scene, Shape } from "#wasm/api";

export type End = "a" | "b";

/** A system of maps is one of a single state. */
export function oneState({ name, maps }: Pick<Shape, "name" | "maps">): DirectedShape {
  return { name, states: [maps.map((map) => ({ from: 0, map }))] };
}

/** The system of a single state; null where there are more. */
export function systemOf({ name, states }: DirectedShape): Shape | null {
  const [only, ...more] = states;
  return only && more.length === 0 ? { name, maps: only.map(({ map }) => map) } : null;
}

/**
 * A graph-directed shape at one end. The other end stays what it is: a system becomes one of a single state. The view,
 * which was that of the systems, is let go where they were there before.
 */
export function withDirected(scene: Scene, end: End, shape: DirectedShape): Scene {
  const other = end === "a" ? "b" : "a";
  if (scene.directed) {
    const { a, b } = scene.directed;
    return { ...scene, directed: { a, b, [end]: shape } };
  }
  const { curves: _, view: __, ...rest } = scene;
  const ends = { a: oneState(scene.a), b: oneState(scene.b) };
  return { ...rest, directed: { ...ends, [other]: ends[other], [end]: shape } };
}

/**
 * A system at one end, where there are graph-directed shapes. Where both ends are systems then, they are the document's
 * again.
 */
export function withSystem(scene: Scene, end: End, shape: Shape): Scene {
  if (!scene.directed) return scene;
  const other = end === "a" ? "b" : "a";
  const beside = systemOf(scene.directed[other]);
  if (!beside) return withDirected(scene, end, oneState(shape));
  const { directed: _, view: __, ...rest } = scene;
  // What the gallery has keeps its name there.
  const kept = JSON.stringify(beside.maps) === JSON.stringify(scene[other].maps) ? scene[other] : beside;
  return { ...rest, [end]: shape, [other]: kept, correspondence: [], turns: [] };
}

/** The same morph, run from the other side. */
export function swapDirected(scene: Scene): Scene {
  if (!scene.directed) return scene;
  const { a, b, halfTurns } = scene.directed;
  return {
    ...scene,
    directed: { a: b, b: a, ...halfTurnsOf({ halfTurns: BACK[halfTurns ?? "signs"] }) },
    t: 1 - scene.t,
  };
}

/** Which way half turns go that are gone back. */
const BACK: Record<HalfTurns, HalfTurns> = {
  signs: "signs",
  counterclockwise: "clockwise",
  clockwise: "counterclockwise",
};

/** Which way half turns go, as far as that has to be said. */
export function halfTurnsOf({ halfTurns }: { halfTurns?: HalfTurns | undefined }): { halfTurns?: HalfTurns } {
  return halfTurns === undefined || halfTurns === "signs" ? {} : { halfTurns };
}

/** Other half turns than those that eq 6 has. */
export function withHalfTurns(scene: Scene, halfTurns: HalfTurns): Scene {
  if (!scene.directed) return scene;
  const { a, b } = scene.directed;
  return { ...scene, directed: { a, b, ...halfTurnsOf({ halfTurns }) } };
}

/** The shape of one end at both. */
export function directedAtBoth(scene: Scene, end: End): Scene {
  if (!scene.directed) return scene;
  const shape = scene.directed[end];
  return { ...scene, directed: { a: shape, b: shape } };
}

/** Other states at one end. The shape keeps its name, and is no longer the gallery's. */
export function setStates(scene: Scene, end: End, states: DirectedShape["states"]): Scene {
  if (!scene.directed) return scene;
  const shape = { name: scene.directed[end].name, states };
  return { ...scene, directed: { ...scene.directed, [end]: shape } };
}

/** Whether both ends are the same: then there is no morph to speak of. */
export function sameDirected({ a, b }: NonNullable<Scene["directed"]>): boolean {
  return a.states === b.states || JSON.stringify(a.states) === JSON.stringify(b.states);
}

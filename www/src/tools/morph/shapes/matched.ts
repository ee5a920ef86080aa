/** Which shapes were given other maps by a way across: nobody has edited them, and they are still what they were. */
import type { Scene, Shape } from "#wasm/api";

const remade = new WeakSet<Shape>();

/** `after` has taken the place of `before` on a way across. What a person has edited stays edited. */
export function noteMatched(before: Shape, after: Shape): Shape {
  if (before.preset !== undefined || remade.has(before)) remade.add(after);
  return after;
}

/** What is said of an end whose maps are not those of the gallery; null where nobody can tell who changed them. */
export function changedWord(shape: Shape, { a, b, mode, path }: Scene): "matched" | "edited" | null {
  if (remade.has(shape)) return "matched";
  // A link does not say it. Both ends are like this where they were matched joint by joint.
  const joined = mode === "linear" && path.kind === "straight" && a.maps.length === b.maps.length;
  return joined && a.preset === undefined && b.preset === undefined ? null : "edited";
}

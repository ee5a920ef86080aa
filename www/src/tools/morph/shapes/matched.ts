/** Which shapes were given other maps by a way across: nobody has edited them, and they are still what they were. */
import { signal } from "@preact/signals";
import type { Scene, Shape } from "#wasm/api";

const remade = new WeakSet<Shape>();
/** How often one was found to be such, which nobody saw become one. */
const learnt = signal(0);

/** `after` has taken the place of `before` on a way across. What a person has edited stays edited. */
export function noteMatched(before: Shape, after: Shape): Shape {
  if (before.preset !== undefined || remade.has(before)) remade.add(after);
  return after;
}

/** It came by a link, and is one. */
export function learnMatched(shape: Shape): void {
  remade.add(shape);
  learnt.value++;
}

/** What is said of an end whose maps are not those of the gallery; null where nobody can tell who changed them. */
export function changedWord(shape: Shape, { a, b, mode, path }: Scene): "matched" | "edited" | null {
  learnt.value;
  if (remade.has(shape)) return "matched";
  // A link does not say it, and `recall.ts` has to look. Both ends are like this where they were matched joint by
  // joint.
  const joined = mode === "linear" && path.kind === "straight" && a.maps.length === b.maps.length;
  return joined && a.preset === undefined && b.preset === undefined ? null : "edited";
}

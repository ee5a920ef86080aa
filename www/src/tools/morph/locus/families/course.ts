/** The curves that the parameter of a family goes along. */
import { signal } from "@preact/signals";
import type { Uv } from "#geometry/path";

/** Round 0, where the copies keep their size, or outwards from 0, where they keep their turn. */
export type Course = "round" | "ray";

/** The largest |s| on a ray: at 1 the copies do not shrink any more. */
export const MOST = 0.95;

/** The one that is gone along: a way of looking, no part of the document. */
export const course = signal<Course>("round");

/** Where s is along its curve, from 0 to 1. */
export function placeOf([x, y]: Uv, along: Course): number {
  if (along === "ray") return Math.min(1, Math.hypot(x, y) / MOST);
  const part = Math.atan2(y, x) / (2 * Math.PI);
  return part < 0 ? part + 1 : part;
}

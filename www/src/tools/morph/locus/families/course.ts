/** The curves that the parameter of a family goes along. */
import { signal } from "@preact/signals";
import type { Uv } from "#geometry/path";

/**
 * Round 0, where the copies keep their size; outwards from 0, where they keep their turn; or into a landmark, turned
 * and drawn nearer by the same factor at every step: there the map looks like itself at every step, too.
 */
export type Course = "round" | "ray" | "spiral";

/** The largest |s| on a ray: at 1 the copies do not shrink any more. */
export const MOST = 0.95;

/** The one that is gone along: a way of looking, no part of the document. */
export const course = signal<Course>("round");

/** Only M has landmarks with spirals; elsewhere s goes round. */
export const courseOf = (sides: number): Course =>
  course.value === "spiral" && sides !== 2 ? "round" : course.value;

/** Where the spiral leads: the landmark that was gone to last. */
export const centre = signal<Uv>([0.37185868007413647, 0.5194111537479428]);

/** How far from its landmark the spiral begins, and in how many steps it comes in. */
const FAR = 0.2;
export const STEPS = 8;

/** What one step of the spiral multiplies by, as the logarithm of its size and its angle. */
export function stepOf([x, y]: Uv): [shrink: number, turn: number] {
  return [Math.log(Math.hypot(x, y)), Math.atan2(y, x)];
}

/** Where s is along its curve, from 0 to 1. */
export function placeOf([x, y]: Uv, along: Course): number {
  if (along === "ray") return Math.min(1, Math.hypot(x, y) / MOST);
  if (along === "spiral") {
    const to = centre.value;
    const [shrink] = stepOf(to);
    const part = Math.log(Math.hypot(x - to[0], y - to[1]) / FAR) / (STEPS * shrink);
    return Math.min(1, Math.max(0, part));
  }
  const part = Math.atan2(y, x) / (2 * Math.PI);
  return part < 0 ? part + 1 : part;
}

const TURN = 2 * Math.PI;

/** The s at a place of the curve through another. */
export function pointAt([x, y]: Uv, along: Course, part: number): Uv {
  if (along === "round") {
    const [size, angle] = [Math.hypot(x, y), TURN * part];
    return [size * Math.cos(angle), size * Math.sin(angle)];
  }
  if (along === "spiral") {
    const to = centre.value;
    const [shrink, turn] = stepOf(to);
    const [dx, dy] = [x - to[0], y - to[1]];
    const far = Math.hypot(dx, dy);
    // How many steps it is from the beginning, be that beyond either end; the landmark itself is on all of them.
    const gone = far > 0 ? Math.log(far / FAR) / shrink : 0;
    const size = FAR * Math.exp(STEPS * part * shrink);
    const angle = Math.atan2(dy, dx) + (STEPS * part - gone) * turn;
    return [to[0] + size * Math.cos(angle), to[1] + size * Math.sin(angle)];
  }
  const [size, angle] = [MOST * part, Math.atan2(y, x)];
  return [size * Math.cos(angle), size * Math.sin(angle)];
}

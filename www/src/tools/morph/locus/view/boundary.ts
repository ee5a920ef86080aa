/** Where what holds ends: the way to it, from where all looks the same. */
import type { Field } from "#compute/locus/pyramid";
import type { Uv } from "#geometry/path";
import { STATE } from "#geometry/states";
import type { Bounds, Locus } from "#wasm/api";

/** What a map says of a sample, as far as colours tell: it holds, it is broken, or neither is known. */
export type Side = "holds" | "broken" | "unknown";

export function sideOf(state: number | undefined): Side {
  switch (state) {
    case STATE.connected:
    case STATE.touching:
      return "holds";
    case STATE.disconnected:
    case STATE.none:
    case STATE.hidden:
      return "broken";
    default:
      return "unknown";
  }
}

/** The one side that all of a field is on, if it is on one, and whether it is proved all over. */
export function uniform({ state }: Pick<Field, "state">): { side: Side; proved: boolean } | null {
  const side = sideOf(state[0]);
  if (side === "unknown") return null;
  let proved = true;
  for (const one of state) {
    if (sideOf(one) !== side) return null;
    proved &&= one !== STATE.touching;
  }
  return { side, proved };
}

/** The sample of a field that is nearest to a place and on the other side; null where there is none. */
export function nearestOther(field: Locus & { bounds: Bounds }, [u, v]: Uv, side: Side): Uv | null {
  const { u0, v0, u1, v1 } = field.bounds;
  const [du, dv] = [(u1 - u0) / Math.max(1, field.width - 1), (v1 - v0) / Math.max(1, field.height - 1)];
  let best: Uv | null = null;
  let least = Number.POSITIVE_INFINITY;
  for (let j = 0; j < field.height; j++) {
    for (let i = 0; i < field.width; i++) {
      const other = sideOf(field.state[j * field.width + i]);
      if (other === side || other === "unknown") continue;
      const at: Uv = [u0 + i * du, v0 + j * dv];
      const far = Math.hypot(at[0] - u, at[1] - v);
      if (far < least) [best, least] = [at, far];
    }
  }
  return best;
}

const COMPASS = [
  "to the right",
  "up and to the right",
  "up",
  "up and to the left",
  "to the left",
  "down and to the left",
  "down",
  "down and to the right",
] as const;

/** A direction in words, by eighths of a turn. */
export function directionWords([u, v]: Uv, [x, y]: Uv): string {
  const eighth = Math.round((4 * Math.atan2(y - v, x - u)) / Math.PI);
  return COMPASS[((eighth % 8) + 8) % 8] ?? COMPASS[0];
}

/** Points of one round between two that are on different sides. */
export const PROBES = 16;

/** Places that divide a line evenly, its ends left out. */
export function probes([u, v]: Uv, [x, y]: Uv): Uv[] {
  return Array.from({ length: PROBES - 1 }, (_, k) => {
    const t = (k + 1) / PROBES;
    return [u + t * (x - u), v + t * (y - v)] as Uv;
  });
}

/** The first stretch of a line, so divided, on which the side changes: what is nearer to its start comes first. */
export function narrowed(from: Uv, to: Uv, states: ArrayLike<number>, side: Side): [from: Uv, to: Uv] {
  const between = probes(from, to);
  let last = from;
  for (const [k, at] of between.entries()) {
    const now = sideOf(states[k]);
    if (now !== side && now !== "unknown") return [last, at];
    if (now === side) last = at;
  }
  return [last, to];
}

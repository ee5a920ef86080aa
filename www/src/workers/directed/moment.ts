import type { DirectedIfs, HalfTurns, Mode } from "#wasm/api";
import { directed } from "#wasm/directed";

/** A way between two graph-directed shapes, both parameters alike. */
export interface Way {
  from: DirectedIfs;
  to: DirectedIfs;
  mode: Mode;
  halfTurns?: HalfTurns;
}

/** A moment of it, 0 to 1. */
export interface Moment extends Way {
  t: number;
}

/** The system there. At the ends nothing is split or doubled: the shapes are as they are. */
export function systemAt({ from, to, t, ...options }: Moment): DirectedIfs {
  if (t <= 0) return from;
  return t >= 1 ? to : directed.interpolateDirected(from, to, { u: t, v: t, ...options });
}

/**
 * The system there as it is drawn. At the ends, too, it is split and doubled as on the way: the shape is the same, and
 * its parts have the colours that they keep all along.
 */
export function drawnAt(moment: Moment): DirectedIfs {
  const { from, to, t, ...options } = moment;
  if (t > 0 && t < 1) return systemAt(moment);
  try {
    const end = t <= 0 ? 0 : 1;
    return directed.interpolateDirected(from, to, { u: end, v: end, ...options });
  } catch {
    // What has no way to the other is drawn as it is.
    return systemAt(moment);
  }
}

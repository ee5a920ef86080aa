import type { DirectedIfs, Mode } from "#wasm/api";
import { directed } from "#wasm/directed";

/** A way between two graph-directed shapes, both parameters alike. */
export interface Way {
  from: DirectedIfs;
  to: DirectedIfs;
  mode: Mode;
}

/** A moment of it, 0 to 1. */
export interface Moment extends Way {
  t: number;
}

/** The system there. At the ends nothing is split or doubled: the shapes are as they are. */
export function systemAt({ from, to, mode, t }: Moment): DirectedIfs {
  if (t <= 0) return from;
  return t >= 1 ? to : directed.interpolateDirected(from, to, { u: t, v: t, mode });
}

import type { Keep } from "../history";

/** The moment of the grid. */
export const keepPhase: Keep = (target, other, { deform }) =>
  target.deform && deform && target.deform.phase === other.deform?.phase
    ? { ...target, deform: { ...target.deform, phase: deform.phase } }
    : target;

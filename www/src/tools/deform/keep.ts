import type { Keep } from "#document/history";

/** The moment of the grid. */
export const keepPhase: Keep = (target, other, { deform }) =>
  target.deform && deform && target.deform.phase === other.deform?.phase
    ? { ...target, deform: { ...target.deform, phase: deform.phase } }
    : target;

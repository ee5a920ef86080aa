/** Closed curves in place of systems: the panel of their morph, their shelf in galleries, and what is said of them. */
export { CurveChip, CurveEvidence } from "./CurveChip";
export { CurvePanel } from "./CurvePanel";
export { Shelf } from "./Shelf";

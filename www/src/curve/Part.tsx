import { CurveChip, CurveEvidence } from "./CurveChip";
import { CurvePanel } from "./CurvePanel";

interface CurvePartProps {
  part: "panel" | "chip" | "evidence";
  /** Opens the gallery for an end. */
  choose: (end: "a" | "b") => void;
}

/** One of the places of the page where closed curves take the place of systems. */
export function CurvePart({ part, choose }: CurvePartProps) {
  if (part === "panel") return <CurvePanel choose={choose} />;
  return part === "chip" ? <CurveChip /> : <CurveEvidence />;
}

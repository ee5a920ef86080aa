/** Graph-directed shapes in place of systems: the panel of their morph, and what is said of them. */
import { DirectedChip, DirectedEvidence } from "./Chip";
import { DirectedPanel } from "./Panel";

interface DirectedPartProps {
  part: "panel" | "chip" | "evidence";
  /** Opens the gallery for an end. */
  choose: (end: "a" | "b") => void;
}

/** One of the places of the page where they take the place of systems. */
export function DirectedPart({ part, choose }: DirectedPartProps) {
  if (part === "panel") return <DirectedPanel choose={choose} />;
  return part === "chip" ? <DirectedChip /> : <DirectedEvidence />;
}

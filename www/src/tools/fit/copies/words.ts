import { significant } from "#format/significant";
import type { CurveCopy } from "#wasm/curve";

/** How an edge lies to the arc that it copies, in a sentence. */
export function copyWords({ span, ratio, across, degrees, mirrored }: CurveCopy): string {
  const parts = [`${significant(ratio, 2)} times as long`, `${significant(across, 2)} times as high`];
  const turn = Math.round(Math.abs(degrees));
  if (turn === 180) parts.push("turned half round");
  else if (turn > 0) parts.push(`turned ${turn}° ${degrees > 0 ? "to the left" : "to the right"}`);
  if (mirrored) parts.push("mirrored");
  return `This edge is that arc of ${span} edges: ${parts.join(", ")}.`;
}

/** How far the curve has grown, in words. */
export function stepWords(steps: number | null): string {
  if (steps === null) return "all of it";
  if (steps === 0) return "the polygon of knots";
  return `${steps} ${steps === 1 ? "step" : "steps"}`;
}

import { significant } from "#format/significant";
import type { CurveCopy } from "#wasm/curve";
import * as messages from "../messages";

/** How an edge lies to the arc that it copies, in a sentence. */
export function copyWords({ span, ratio, across, degrees, mirrored }: CurveCopy): string {
  const parts = [messages.timesAsLong(significant(ratio, 2)), messages.timesAsHigh(significant(across, 2))];
  const turn = Math.round(Math.abs(degrees));
  if (turn === 180) parts.push(messages.rotatedByHalfTurn);
  else if (turn > 0)
    parts.push(messages.rotatedTo(turn, degrees > 0 ? messages.toTheLeft : messages.toTheRight));
  if (mirrored) parts.push(messages.mirroredToo);
  return messages.edgeCopies(span, parts.join(", "));
}

/** How far the curve has grown, in words. */
export function stepWords(steps: number | null): string {
  if (steps === null) return messages.allOfIt;
  if (steps === 0) return messages.polygonKnots;
  return `${steps} ${steps === 1 ? "step" : "steps"}`;
}

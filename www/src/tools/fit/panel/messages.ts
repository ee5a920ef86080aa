/** What the panel adds to the words of a mask, in the names of its own controls. */
import type { TraceWarning } from "#workers/fit/trace-types";

/** How to bring back what surrounds the picture; a stroke of exactly what is painted brings back no more than that. */
export function bringBackWords(warnings: readonly TraceWarning[], exact: boolean): string | null {
  if (!warnings.some(({ code }) => code === "surrounded")) return null;
  const off = exact ? "switch off “Only what is painted”, " : "";
  return `To bring back what is left out, choose Leaf under Brush, ${off}and draw a stroke on it.`;
}

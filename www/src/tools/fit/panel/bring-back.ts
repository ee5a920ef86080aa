/** What the panel adds to the words of a mask, in the names of its own controls. */
import type { TraceWarning } from "#workers/fit/trace-types";
import * as messages from "./messages";

/**
 * What has to be done first where a stroke is to bring back what surrounds the picture, as the warning itself tells: a
 * stroke of exactly what is painted brings back no more than that.
 */
export function bringBackWords(warnings: readonly TraceWarning[], exact: boolean): string | null {
  if (!exact || !warnings.some(({ code }) => code === "surrounded")) return null;
  return messages.turnOffDoNot;
}

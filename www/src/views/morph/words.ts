import type { Verdict } from "../../engine/api";
import { STATE } from "../../engine/breaks";
import { formatNumber } from "../../ui/number";

/** The resolution at which the page judges: pieces within 1/600 of the diameter count as touching. */
export const RESOLUTION = 600;

/** A verdict in words. `touching` is never called proved. */
export function verdictWords(verdict: Verdict | null): string {
  switch (verdict) {
    case "connected":
      return "in one piece";
    case "touching":
      return `in one piece at ${RESOLUTION} px`;
    case "disconnected":
      return "broken";
    case "undecided":
      return "not decided";
    case "no-attractor":
      return "no shape";
    case null:
      return "not looked at yet";
  }
}

/** The same for one sample of the field. */
export function stateWords(state: number): string {
  switch (state) {
    case STATE.connected:
      return verdictWords("connected");
    case STATE.touching:
      return verdictWords("touching");
    case STATE.disconnected:
      return verdictWords("disconnected");
    case STATE.undecided:
      return verdictWords("undecided");
    case STATE.none:
      return verdictWords("no-attractor");
    default:
      return verdictWords(null);
  }
}

export const percent = (t: number): string => `${Math.round(100 * t)}%`;

/** How far apart, in hundredths of the size of the shape. */
export function gapWords(gap: number): string {
  if (!(gap > 0)) return "no gap";
  return gap < 0.0005 ? "under 0.1% of its size" : `${formatNumber(100 * gap, 1)}% of its size`;
}

/** "A", "A and B", "A, B and C". */
export function listWords(items: readonly string[]): string {
  if (items.length < 2) return items.join("");
  return `${items.slice(0, -1).join(", ")} and ${items.at(-1) ?? ""}`;
}

/** Stretches in whole per cents; those that touch then are one. */
function joined(breaks: readonly { t0: number; t1: number }[]): [from: number, to: number][] {
  const spans: [number, number][] = [];
  for (const { t0, t1 } of breaks) {
    const [from, to] = [Math.round(100 * t0), Math.round(100 * t1)];
    const last = spans.at(-1);
    if (last !== undefined && from <= last[1]) last[1] = Math.max(last[1], to);
    else spans.push([from, to]);
  }
  return spans;
}

/** The whole path in one sentence. */
export function pathWords(
  breaks: readonly { t0: number; t1: number }[],
  widest: number | null,
  progress: number,
): string {
  if (progress <= 0) return "Looking along the path …";
  const so = progress < 1 ? " so far" : "";
  if (breaks.length === 0) return `In one piece all the way${so}, at ${RESOLUTION} px.`;
  const spans = joined(breaks).map(([from, to]) =>
    from === to ? `at ${from}%` : `between ${from}% and ${to}%`,
  );
  const shown = spans.length > 3 ? [...spans.slice(0, 2), `in ${spans.length - 2} more places`] : spans;
  const gap = widest !== null && widest > 0 ? `, widest gap ${gapWords(widest)}` : "";
  return `Breaks ${listWords(shown)}${so}${gap}.`;
}

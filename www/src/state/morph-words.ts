import type { Verdict } from "../engine/api";
import { STATE } from "../engine/breaks";
import { formatNumber } from "../ui/number";

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

/** Which map becomes which, as far as it is short enough to be heard. */
export function matchWords(correspondence: readonly number[], turns: readonly number[]): string {
  const moved = correspondence.flatMap((to, from) => (to === from ? [] : [`${from + 1} becomes ${to + 1}`]));
  const partners =
    moved.length === 0
      ? "each keeps its number"
      : moved.length <= 4
        ? listWords(moved)
        : `${moved.length} of ${correspondence.length} maps change partner`;
  const turning = turns.filter((turn) => turn !== 0).length;
  if (turning === 0) return partners;
  return `${partners}; ${turning === 1 ? "one turns" : `${turning} turn`} further`;
}

/** What a way to match allows: its best path. */
export function meritWords(plan: { holds: boolean; gap: number }): string {
  if (plan.holds) return "holds all the way";
  if (!Number.isFinite(plan.gap)) return "meets no shape on the way";
  return `gap ${shareWords(plan.gap)}`;
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

/** How near a path that holds comes to breaking, in units of u and v; nothing to say where it does not. */
export function roomWords(clearance: number | null | undefined): string {
  if (clearance === null || clearance === undefined || !Number.isFinite(clearance)) return "";
  if (clearance < 0.015) return "It runs along the very edge of what holds.";
  return `It keeps ${formatNumber(clearance, 2)} away from what breaks.`;
}

/** What was proved of a path, so far or in whole. */
export function certifiedWords(so: {
  done: number;
  parts: number;
  gap: number;
  boxes: number;
  worst: number;
  problem: string | null;
}): string {
  if (so.problem !== null) return `It could not be proved. ${so.problem}`;
  if (so.done < so.parts) return `Proving it: ${percent(so.done / so.parts)} of the path.`;
  const boxes = `${so.boxes.toLocaleString("en")} ${so.boxes === 1 ? "box" : "boxes"}`;
  if (!Number.isFinite(so.gap))
    return `No bound could be proved all the way: at ${percent(so.worst)} it would take more than the ${boxes} that were looked at.`;
  if (so.gap === 0) return `In one piece everywhere on this path: proved with ${boxes}.`;
  return `No gap wider than ${shareWords(so.gap)} of the shape anywhere on this path: proved with ${boxes}. The bound is weakest at ${percent(so.worst)}.`;
}

/** A part of the size of the shape in hundredths, with two figures that count: "0.31%". Never less than it is. */
export function shareWords(share: number): string {
  const hundredths = 100 * share;
  if (!(hundredths > 0)) return "0%";
  const digits = Math.max(0, Math.min(6, 1 - Math.floor(Math.log10(hundredths))));
  const up = Math.ceil(hundredths * 10 ** digits - 1e-9) / 10 ** digits;
  return up === 0 ? "0.000001%" : `${Number(up.toFixed(digits))}%`;
}

/** What is known where the best path breaks. `apart`: on the samples there is no way that does not. */
export function bestWords(apart: boolean, third: boolean): string {
  const where = third ? "Even with the third parameter no path" : "No path on this square";
  return apart
    ? `${where} can hold all the way, as far as the map is known: this one breaks least.`
    : `${where} was found to hold all the way: this one breaks least.`;
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

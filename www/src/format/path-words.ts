import { provedPart, STATE, type Stretch, stretches } from "#geometry/states";
import { formatNumber } from "./numbers";
import { OWN_BOUNDS, RESOLUTION, resolutionWords, shareWords, toldOf, verdictWords } from "./verdict";

export const percent = (t: number): string => `${Math.round(100 * t)}%`;

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
  return `${partners}; ${turning === 1 ? "one turns" : `${turning} turn`} differently`;
}

/** Which way round a half turn goes that so many whole turns (1 or -1) would make the other one. */
export const halfTurnWay = (other: number): string => (other > 0 ? "clockwise" : "counter-clockwise");

/**
 * Which maps turn by half a turn, and that there are two of them; `other` as `halfTurns` gives it, null where none
 * does.
 */
export function halfTurnWords(other: readonly number[]): string | null {
  const maps = other.flatMap((turn, i) => (turn === 0 ? [] : [{ number: String(i + 1), turn }]));
  const [only, ...more] = maps;
  if (!only) return null;
  if (more.length === 0) {
    const [now, then] = [halfTurnWay(only.turn), halfTurnWay(-only.turn)];
    return `Map ${only.number} makes exactly half a turn, ${now}. Half a turn ${then} is as short.`;
  }
  return `Maps ${listWords(maps.map(({ number }) => number))} make exactly half a turn, which is as short either way.`;
}

/** What a way to match allows: its best path. */
export function meritWords(plan: { holds: boolean; gap: number }): string {
  if (plan.holds) return "looks whole all the way";
  if (!Number.isFinite(plan.gap)) return "no attractor on the way";
  return `gap ${shareWords(plan.gap)}`;
}

/** Stretches in whole per cents; those that touch then are one. */
function joined(found: readonly Stretch[]): [from: number, to: number][] {
  const spans: [number, number][] = [];
  for (const { t0, t1 } of found) {
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
  joints?: number;
  worst: number;
  problem: string | null;
}): string {
  if (so.problem !== null) return `It could not be proved. ${so.problem}`;
  if (so.done < so.parts) return `Proving it: ${percent(so.done / so.parts)} of the path.`;
  if (so.boxes === 0 && so.joints)
    return `Proved, at every moment of this path: each piece joins the next in one of ${so.joints} joints, and all joints stay joined, to ${so.gap.toExponential(0)} of the shape’s diameter, which is rounding.`;
  const steps = `${so.boxes.toLocaleString("en")} ${so.boxes === 1 ? "step" : "steps"}`;
  if (!Number.isFinite(so.gap))
    return `It could not be proved all the way: at ${percent(so.worst)} it would take more than ${steps}.`;
  if (so.gap === 0) return `In one piece, proved, at every moment of this path, in ${steps}.`;
  return `No moment of this path has a gap wider than ${shareWords(so.gap)} of the shape’s diameter: proved, in ${steps}. Between the moments looked at, this leaves narrower gaps possible, the widest of them near ${percent(so.worst)}.`;
}

/** What is known where the best path breaks. `apart`: on the samples there is no way that does not. */
export function bestWords(apart: boolean, third: boolean): string {
  const where = third ? "Even with the third parameter no path" : "No path on this square";
  return apart
    ? `${where} can hold all the way, as far as the map is known: this one breaks least.`
    : `${where} was found to hold all the way: this one breaks least.`;
}

/** What is known of a path: of its moments, and by a proof of all of it. */
interface PathKnown {
  /** The states of moments that are evenly spaced over [0, 1]. */
  states: ArrayLike<number>;
  /** The widest gap met, as a part of the diameter. */
  widest: number;
  /** Whether it is proved to be in one piece at every moment. */
  proved?: boolean;
  /** How much of the path, or of what it is read off, has been looked at: 0 to 1. */
  progress?: number;
}

/** The whole path in a sentence or two, in the words that are said of a shape. */
export function pathWords({ states, widest, proved = false, progress = 1 }: PathKnown): string {
  if (progress <= 0 || states.length === 0) return "Looking along the path …";
  const so = progress < 1 ? " so far" : "";
  const said = (about: number, gap: string) => {
    const where = whereWords(stretches(states, (state) => state === about));
    const told = toldOf(about, widest);
    return where === "" || told === null ? [] : [`${placed(verdictWords(told).text, where)}${so}${gap}.`];
  };
  const wide = said(STATE.disconnected, `, widest gap ${shareWords(widest)}, ${OWN_BOUNDS}`);
  // Where wider gaps are told of, those that nobody sees are not worth a sentence.
  const least = resolutionWords(RESOLUTION);
  // Of what is read off the map only that much is known.
  const finer =
    widest > 0 ? `, gap ${shareWords(widest)}, finer than ${least}` : `, by a gap finer than ${least}`;
  const narrow = wide.length === 0 ? said(STATE.hidden, `${finer}, ${OWN_BOUNDS}`) : [];
  const words = [...wide, ...narrow, ...said(STATE.none, ""), ...said(STATE.undecided, "")];
  if (words.length > 0) return words.join(" ");
  const [whole, looks] = [STATE.connected, STATE.touching].map(
    (state) => verdictWords(toldOf(state, 0)).text,
  );
  const part = proved ? 1 : (provedPart(states) ?? 0);
  if (part === 0) return `${looks} all the way${so}.`;
  // Moments are no proof of what lies between them.
  if (part === 1) return `${whole}, ${proved ? "all the way" : "at each moment looked at"}${so}.`;
  return `${whole}, at ${partWords(part)} of the moments looked at${so}. The others look whole at ${resolutionWords(RESOLUTION)}.`;
}

/** A part that is neither nothing nor all, in whole per cents that say neither. */
export const partWords = (part: number): string =>
  part < 0.01 ? "less than 1%" : `${Math.min(99, Math.floor(100 * part))}%`;

/** "In pieces at 50%", "Not decided at 50%" */
const placed = (text: string, where: string) => `${text} ${where}`;

/** "between 62% and 80%", "at 50%"; two places of many, and how many more there are. */
function whereWords(found: readonly Stretch[]): string {
  const spans = joined(found).map(([from, to]) =>
    from === to ? `at ${from}%` : `between ${from}% and ${to}%`,
  );
  return listWords(spans.length > 3 ? [...spans.slice(0, 2), `in ${spans.length - 2} more places`] : spans);
}

import { provedPart, STATE, type Stretch, stretches } from "#geometry/states";
import * as messages from "./messages";
import { formatNumber } from "./numbers";
import { listOf } from "./plural";
import { OWN_BOUNDS, RESOLUTION, resolutionWords, shareWords, toldOf, verdictWords } from "./verdict";

export const percent = (t: number): string => `${Math.round(100 * t)}%`;

/** "A", "A and B", "A, B and C". */
export function listWords(items: readonly string[]): string {
  return listOf(items);
}

/** Which map becomes which, as far as it is short enough to be heard. */
export function matchWords(correspondence: readonly number[], turns: readonly number[]): string {
  const moved = correspondence.flatMap((to, from) =>
    to === from ? [] : [messages.becomes(from + 1, to + 1)],
  );
  const partners =
    moved.length === 0
      ? messages.sameNumbers
      : moved.length <= 4
        ? listWords(moved)
        : messages.changePartner(moved.length, correspondence.length);
  const turning = turns.filter((turn) => turn !== 0).length;
  if (turning === 0) return partners;
  return messages.turnDifferently(partners, turning);
}

/** Which way round a half turn goes that so many whole turns (1 or -1) would make the other one. */
export const halfTurnWay = (other: number): string =>
  other > 0 ? messages.clockwise : messages.counterClockwise;

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
    return messages.halfTurnOfOne(only.number, now, then);
  }
  return messages.halfTurnOfSeveral(listWords(maps.map(({ number }) => number)));
}

/** What a way to match allows: its best path. */
export function meritWords(plan: { holds: boolean; gap: number }): string {
  if (plan.holds) return messages.noGapOnPath;
  if (!Number.isFinite(plan.gap)) return messages.noAttractorOnPath;
  return messages.gapOf(shareWords(plan.gap));
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
  if (clearance < 0.015) return messages.runsRightAlongBorder;
  return messages.keepsAway(formatNumber(clearance, 2));
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
  if (so.problem !== null) return messages.notProved(so.problem);
  if (so.done < so.parts) return messages.proving(percent(so.done / so.parts));
  if (so.boxes === 0 && so.joints) return messages.jointsProved(so.joints, so.gap.toExponential(0));
  const steps = messages.steps(so.boxes);
  if (!Number.isFinite(so.gap)) return messages.proofTooLong(percent(so.worst), steps);
  if (so.gap === 0) return messages.pathProved(steps);
  return messages.gapsBounded(steps, shareWords(so.gap), percent(so.worst));
}

/** What is known where the best path breaks. `apart`: on the samples there is no way that does not. */
export function bestWords(apart: boolean, third: boolean): string {
  if (apart) return third ? messages.everyPathBreaksEvenThen : messages.everyPathBreaks;
  return third ? messages.noPathFoundEvenThen : messages.noPathFound;
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
  if (progress <= 0 || states.length === 0) return messages.checkingPath;
  const so = progress < 1 ? messages.soFar : "";
  const said = (about: number, gap: string) => {
    const where = whereWords(stretches(states, (state) => state === about));
    const told = toldOf(about, widest);
    return where === "" || told === null ? [] : [`${placed(verdictWords(told).text, where)}${so}${gap}.`];
  };
  const wide = said(STATE.disconnected, messages.widestGap(shareWords(widest), OWN_BOUNDS));
  const least = resolutionWords(RESOLUTION);
  // Where wider gaps are told of, those that nobody sees are not worth a sentence.
  // Of what is read off the map only that much is known.
  const finer = widest > 0 ? messages.gapUnder(shareWords(widest), least) : messages.someGapUnder(least);
  const narrow = wide.length === 0 ? said(STATE.hidden, `${finer}, ${OWN_BOUNDS}`) : [];
  const words = [...wide, ...narrow, ...said(STATE.none, ""), ...said(STATE.undecided, "")];
  if (words.length > 0) return words.join(" ");
  const part = proved ? 1 : (provedPart(states) ?? 0);
  if (part === 0) return messages.noGapAnywhere(least, so);
  // Moments are no proof of what lies between them.
  if (part === 1) return (proved ? messages.provedThroughout : messages.provedAtSamples)(so);
  return messages.provedAtSome(partWords(part), so, least);
}

/** A part that is neither nothing nor all, in whole per cents that say neither. */
export const partWords = (part: number): string =>
  part < 0.01 ? messages.lessThanOne : `${Math.min(99, Math.floor(100 * part))}%`;

/** "In pieces at 50%", "Not decided at 50%" */
const placed = messages.verdictAt;

/** "between 62% and 80%", "at 50%"; two places of many, and how many more there are. */
function whereWords(found: readonly Stretch[]): string {
  const spans = joined(found).map(([from, to]) =>
    from === to ? messages.atMoment(from) : messages.between(from, to),
  );
  return listWords(spans.length > 3 ? [...spans.slice(0, 2), messages.morePlaces(spans.length - 2)] : spans);
}

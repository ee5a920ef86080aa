/** Edits of a time line. Each gives back the one it was given where there is nothing to change. */

import { SAME_KEY_S } from "#document/space/edits";
import { formatNumber } from "#format/numbers";
import type { Ease, Repeat, SpaceKey, SpaceTimeline } from "#wasm/api";
import * as messages from "./messages";

export const MOST_KEYS = 100;
export const SHORTEST = 0.1;
export const LONGEST = 600;

/** As fine as anyone can point, and short in a link. */
export const rounded = (at: number): number => Math.round(at * 1000) / 1000;

/** The moment of the time line that is nearest. */
export function momentIn({ seconds }: Pick<SpaceTimeline, "seconds">, at: number): number {
  if (!Number.isFinite(at)) return 0;
  return rounded(Math.min(seconds, Math.max(0, at)));
}

/** The number of the key at a moment, or -1. */
export function keyAt({ keys }: Pick<SpaceTimeline, "keys">, at: number): number {
  return keys.findIndex((key) => Math.abs(key.at - at) < SAME_KEY_S);
}

/** A key at another moment. Keys keep their order, and do not meet. */
export function withKeyAt(line: SpaceTimeline, index: number, at: number): SpaceTimeline {
  const { keys } = line;
  const key = keys[index];
  if (!key || !Number.isFinite(at)) return line;
  const before = keys[index - 1];
  const behind = keys[index + 1];
  const least = before ? before.at + 2 * SAME_KEY_S : 0;
  const most = behind ? behind.at - 2 * SAME_KEY_S : line.seconds;
  const to = rounded(Math.max(least, Math.min(most, at)));
  return to === key.at || least > most ? line : withItem(line, index, { ...key, at: to });
}

export function withEase(line: SpaceTimeline, index: number, ease: Ease): SpaceTimeline {
  const key = line.keys[index];
  return !key || key.ease === ease ? line : withItem(line, index, { ...key, ease });
}

export function withoutKey(line: SpaceTimeline, index: number): SpaceTimeline {
  if (!line.keys[index]) return line;
  return { ...line, keys: line.keys.filter((_, i) => i !== index) };
}

function withItem(line: SpaceTimeline, index: number, item: SpaceKey): SpaceTimeline {
  return { ...line, keys: line.keys.map((key, i) => (i === index ? item : key)) };
}

/** Why a time line cannot be so long, or nothing. */
export function secondsProblem(line: SpaceTimeline, seconds: number): string | undefined {
  const last = line.keys.at(-1);
  if (!last || last.at <= seconds) return undefined;
  return messages.keyAfterEnd(line.keys.length, formatNumber(last.at, 2));
}

export function withSeconds(line: SpaceTimeline, seconds: number): SpaceTimeline {
  if (seconds === line.seconds || secondsProblem(line, seconds) !== undefined) return line;
  return { ...line, seconds };
}

/** What comes after the end. */
export function withLoop(line: SpaceTimeline, loop: Repeat): SpaceTimeline {
  return loop === line.loop ? line : { ...line, loop };
}

/** Whether it goes round, and may jump from a key at its end to one at its beginning. */
export function jumpsBack({ keys, loop, seconds }: SpaceTimeline): boolean {
  return loop === "round" && keys.length > 1 && keys[0]?.at === 0 && keys.at(-1)?.at === seconds;
}

/** All of it slower by a factor, or faster. The same where it would be too long or short, or keys would meet. */
export function stretched(line: SpaceTimeline, factor: number): SpaceTimeline {
  const seconds = rounded(line.seconds * factor);
  if (!(factor > 0) || seconds < SHORTEST || seconds > LONGEST) return line;
  const keys = line.keys.map((key) => ({ ...key, at: rounded(key.at * factor) }));
  const meet = keys.some((key, i) => i > 0 && key.at - (keys[i - 1]?.at ?? 0) < SAME_KEY_S);
  const after = { ...line, seconds, keys };
  return meet || secondsProblem(after, seconds) !== undefined ? line : after;
}

/** The moment of the next key in a direction, round the end where it loops; the same moment where there is none. */
export function nextKey({ keys, loop }: SpaceTimeline, at: number, by: 1 | -1): number {
  const moments = keys.map((key) => key.at);
  const ahead =
    by > 0 ? moments.find((x) => x > at + SAME_KEY_S) : moments.findLast((x) => x < at - SAME_KEY_S);
  return ahead ?? (loop === "round" ? moments.at(by > 0 ? 0 : -1) : undefined) ?? at;
}

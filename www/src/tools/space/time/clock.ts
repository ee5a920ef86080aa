/** Plays the time line of space. */

import { whilePlaying } from "#document/frames";
import { reducedMotion } from "#document/preferences";
import { EMPTY_LINE } from "#document/space/edits";
import { moment, setMoment, spacePlaying, timeline } from "#document/space/space";
import type { SpaceTimeline } from "#wasm/api";
import { momentIn } from "./time-edits";

/** Where the moment is after `dt` seconds, and which way it goes from there. Pure, for the tests. */
export function advance(
  at: number,
  dt: number,
  { seconds, loop }: Pick<SpaceTimeline, "seconds" | "loop">,
  way: 1 | -1 = 1,
): { at: number; way: 1 | -1; ended: boolean } {
  if (loop === "round") return { at: wrapped(at + dt, seconds), way: 1, ended: false };
  if (loop === "pingpong") {
    // There and back is one round.
    const next = wrapped((way > 0 ? at : 2 * seconds - at) + dt, 2 * seconds);
    return next < seconds
      ? { at: next, way: 1, ended: false }
      : { at: 2 * seconds - next, way: -1, ended: false };
  }
  const next = at + dt;
  return { at: Math.min(seconds, Math.max(0, next)), way: 1, ended: next >= seconds };
}

const wrapped = (at: number, length: number) => at - length * Math.floor(at / length);

/** Which way it goes, where it goes to and fro. */
let way: 1 | -1 = 1;

function step(dt: number): void {
  const line = timeline.peek();
  // What was undone may have taken the keys along.
  if (!line || line.keys.length < 2) {
    spacePlaying.value = false;
    return;
  }
  const next = advance(moment.peek(), dt, line, way);
  way = next.way;
  setMoment(next.at);
  if (next.ended) pauseSpace();
}

/** Only who asks for it sees it move. */
function playSpace(): void {
  const line = timeline.peek();
  if (spacePlaying.peek() || !line || line.keys.length < 2) return;
  const over = moment.peek() >= line.seconds;
  if (line.loop !== "pingpong" || moment.peek() <= 0) way = 1;
  else if (over) way = -1;
  if (over && line.loop !== "pingpong") setMoment(0);
  spacePlaying.value = true;
}

export function pauseSpace(): void {
  if (!spacePlaying.peek()) return;
  spacePlaying.value = false;
  setMoment(momentIn(timeline.peek() ?? EMPTY_LINE, moment.peek()));
}

export function togglePlay(): void {
  if (spacePlaying.peek()) pauseSpace();
  else playSpace();
}

/** Plays what was just made, unless nothing is to move by itself. */
export function presentSpace(): void {
  setMoment(0);
  if (!reducedMotion.peek()) playSpace();
}

/** What plays stops, and the moment is this one, seen as the time line has it. */
export function scrubSpace(at: number): void {
  pauseSpace();
  way = 1;
  setMoment(momentIn(timeline.peek() ?? EMPTY_LINE, at));
}

whilePlaying(spacePlaying, step, pauseSpace);

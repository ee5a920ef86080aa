/** Plays the time line of space. */
import { whilePlaying } from "../../../state/frames";
import { reducedMotion } from "../../../state/preferences";
import { moment, setMoment, spacePlaying, timeline } from "../../../state/space";
import { EMPTY_LINE } from "../../../state/space-edits";
import { momentIn } from "./changes";

/** Where the moment is after `dt` seconds. Pure, for the tests. */
export function advance(
  at: number,
  dt: number,
  { seconds, loop }: { seconds: number; loop: boolean },
): { at: number; ended: boolean } {
  const next = at + dt;
  if (loop) return { at: next - seconds * Math.floor(next / seconds), ended: false };
  return { at: Math.min(seconds, Math.max(0, next)), ended: next >= seconds };
}

function step(dt: number): void {
  const line = timeline.peek();
  // What was undone may have taken the keys along.
  if (!line || line.keys.length < 2) {
    spacePlaying.value = false;
    return;
  }
  const next = advance(moment.peek(), dt, line);
  setMoment(next.at);
  if (next.ended) pauseSpace();
}

/** Only who asks for it sees it move. */
export function playSpace(): void {
  const line = timeline.peek();
  if (spacePlaying.peek() || !line || line.keys.length < 2) return;
  if (!line.loop && moment.peek() >= line.seconds) setMoment(0);
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
  setMoment(momentIn(timeline.peek() ?? EMPTY_LINE, at));
}

whilePlaying(spacePlaying, step, pauseSpace);

import { signal } from "@preact/signals";
import { whilePlaying } from "#document/frames";
import { endGesture } from "#document/scene";
import { spacePart, spacePlaying } from "#document/space/space";
import { advance } from "#geometry/moment";
import { goTo } from "./waypoints";
import { moment } from "./work";

/** Whether the morph runs back and forth. */
export const morphPlaying = signal(false);

let direction = 1;
/** In between, the place is finer than the document keeps it. */
let exact = 0;
/** What was played last: whatever else changes ends it. */
let played = "";

export function play(): void {
  // Two that move the same thing would fight.
  spacePlaying.value = false;
  exact = moment.peek();
  direction = exact >= 1 ? -1 : 1;
  played = spacePart.peek().packed;
  morphPlaying.value = true;
}

/** All that was played is one undo step. */
export function pause(): void {
  if (!morphPlaying.peek()) return;
  morphPlaying.value = false;
  endGesture();
}

function step(dt: number): void {
  if (spacePlaying.peek() || spacePart.peek().packed !== played) {
    pause();
    return;
  }
  const next = advance(exact, dt, direction, { speed: 1, loop: true });
  exact = next.t;
  direction = next.way;
  goTo(exact);
  played = spacePart.peek().packed;
}

whilePlaying(morphPlaying, step, pause);

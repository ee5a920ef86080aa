/** Plays the time line of the mesh. */
import { deformation, phasePlaying, replaceDeformation } from "#document/deform/bend";
import { whilePlaying } from "#document/frames";
import { reducedMotion } from "#document/preferences";

const FINEST = 1e4;

/** Where the moment is after `dt` seconds. Pure, for the tests. */
export function advance(
  phase: number,
  dt: number,
  { seconds, loop }: { seconds: number; loop: boolean },
): { phase: number; ended: boolean } {
  const next = phase + dt / seconds;
  if (loop) return { phase: next - Math.floor(next), ended: false };
  return { phase: Math.min(1, Math.max(0, next)), ended: next >= 1 };
}

function step(dt: number): void {
  const before = deformation.peek();
  // What was undone may have taken the motion along.
  if (before.keys.length < 2) {
    phasePlaying.value = false;
    return;
  }
  const next = advance(before.phase, dt, before);
  if (next.phase !== before.phase) replaceDeformation((d) => ({ ...d, phase: next.phase }));
  if (next.ended) pausePhase();
}

/** Only who asks for it sees it move. */
export function playPhase(): void {
  const { keys, loop, phase } = deformation.peek();
  if (phasePlaying.peek() || keys.length < 2) return;
  if (phase >= 1 && !loop) replaceDeformation((d) => ({ ...d, phase: 0 }));
  phasePlaying.value = true;
}

/** Plays what was just made, unless nothing is to move by itself: then it shows a moment of it. */
export function presentPhase(): void {
  if (reducedMotion.peek()) setPhase(0.25);
  else playPhase();
}

export function pausePhase(): void {
  if (phasePlaying.peek()) setPhase(deformation.peek().phase);
  phasePlaying.value = false;
}

/** Moves in time by hand. The moment is no undo step. */
function setPhase(phase: number): void {
  const clamped = Number.isFinite(phase) ? Math.min(1, Math.max(0, phase)) : 0;
  // As fine as anyone can point, and short in a link.
  const rounded = Math.round(clamped * FINEST) / FINEST;
  if (rounded === deformation.peek().phase) return;
  replaceDeformation((d) => ({ ...d, phase: rounded }));
}

/** What plays stops, and the moment is this one. */
export function scrubPhase(phase: number): void {
  pausePhase();
  setPhase(phase);
}

whilePlaying(phasePlaying, step, pausePhase);

/** Plays the time line of the mesh. */
import { effect } from "@preact/signals";
import { deformation, phasePlaying, replaceDeformation } from "../../state/bend";
import { reducedMotion } from "../../state/preferences";

const FINEST = 1e4;
let last: number | null = null;
let frame = 0;

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

function tick(now: number): void {
  frame = 0;
  if (!phasePlaying.peek()) return;
  const before = deformation.peek();
  // What was undone may have taken the motion along.
  if (before.keys.length < 2) {
    phasePlaying.value = false;
    return;
  }
  // A frame that comes late, after a stall, moves by a tenth of a second at most.
  const dt = last === null ? 0 : Math.min(0.1, (now - last) / 1000);
  last = now;
  const step = advance(before.phase, dt, before);
  if (step.phase !== before.phase) replaceDeformation((d) => ({ ...d, phase: step.phase }));
  if (step.ended) pausePhase();
  else frame = requestAnimationFrame(tick);
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
export function setPhase(phase: number): void {
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

effect(() => {
  const go = phasePlaying.value;
  if (typeof requestAnimationFrame === "undefined") return;
  if (go && !frame) {
    last = null;
    frame = requestAnimationFrame(tick);
  } else if (!go && frame) {
    cancelAnimationFrame(frame);
    frame = 0;
  }
});

if (typeof document !== "undefined") {
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) pausePhase();
  });
}

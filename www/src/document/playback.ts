/** The moment of the morph as it plays. */
import { signal } from "@preact/signals";
import { advance } from "#geometry/moment";
import { whilePlaying } from "./frames";
import { replace, scene } from "./scene";

export const playing = signal(false);
/** Back and forth for ever; else it stops at the end. */
export const loop = signal(true);
/** 1 takes as long as `SECONDS` of geometry/moment says from one end to the other. */
export const speed = signal(1);
const FINEST = 1e4;

let direction = 1;

function step(dt: number): void {
  const before = scene.peek();
  const next = advance(before.t, dt, direction, { speed: speed.peek(), loop: loop.peek() });
  direction = next.way;
  if (next.t !== before.t) replace({ ...before, t: next.t });
  if (next.ended) playing.value = false;
}

/** Only who asks for it sees it move: nothing calls this by itself. */
export function play(): void {
  if (playing.peek()) return;
  const before = scene.peek();
  if (before.t >= 1 && !loop.peek()) replace({ ...before, t: 0 });
  direction = before.t >= 1 && loop.peek() ? -1 : 1;
  playing.value = true;
}

export function pause(): void {
  if (playing.peek()) setT(scene.peek().t);
  playing.value = false;
}

/** Moves along the path, by hand. The moment is no undo step, so that undo stays for what was made. */
export function setT(t: number, _gesture?: string): void {
  const clamped = Number.isFinite(t) ? Math.min(1, Math.max(0, t)) : 0;
  // As fine as anyone can point, and short in a link.
  const rounded = Math.round(clamped * FINEST) / FINEST;
  const before = scene.peek();
  if (rounded !== before.t) replace({ ...before, t: rounded });
}

whilePlaying(playing, step, pause);

/**
 * Whether the time line of space plays, and whether its complete picture is on the stage: here, since space is loaded
 * late.
 */
export const spacePlaying = signal(false);
export const spaceShown = signal(false);

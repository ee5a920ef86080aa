import { effect, type Signal } from "@preact/signals";

/** Of a frame that comes late, after a stall, so much counts, in seconds: nobody likes a jump. */
const LATEST = 0.1;

/** Calls `step` with the seconds since the last one, once a frame for as long as it plays; a hidden tab stops it. */
export function whilePlaying(playing: Signal<boolean>, step: (dt: number) => void, stop: () => void): void {
  let last: number | null = null;
  let frame = 0;
  const tick = (now: number) => {
    frame = 0;
    if (!playing.peek()) return;
    const dt = last === null ? 0 : Math.min(LATEST, (now - last) / 1000);
    last = now;
    step(dt);
    if (playing.peek() && !frame) frame = requestAnimationFrame(tick);
  };
  effect(() => {
    const go = playing.value;
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
      if (document.hidden) stop();
    });
  }
}

/** What moves by itself once it is opened: as it was shared, or on a first visit. */
import { effect } from "@preact/signals";
import { phasePlaying } from "#document/deform/bend";
import { playing, spacePlaying } from "#document/playback";
import { reducedMotion } from "#document/preferences";
import type { Timeline } from "#ui/strip/timeline";
import { openedTool } from "./tools";

/** Whether something plays. */
export const moving = () => playing.peek() || phasePlaying.peek() || spacePlaying.peek();

/**
 * Plays as soon as its tool is there; not for those who want less motion. Once is there and back, so that it ends as it
 * was sent; what was sent at its end is played up to there from the beginning.
 */
export function moveBySelf(how: "on" | "once"): void {
  if (reducedMotion.peek()) return;
  const stop = effect(() => {
    const { tool } = openedTool();
    if (!tool) return;
    queueMicrotask(() => {
      stop();
      const line = tool.timeline;
      if (!line || line.length() <= 0) return;
      if (how === "on") line.toggle();
      else once(line);
    });
  });
}

/** How far two moments are apart, on a line of this length that may begin again at its end. */
const apart = (from: number, to: number, length: number) => {
  const plain = Math.abs(to - from);
  return { far: Math.min(plain, length - plain), again: plain > length / 2 };
};

/** Whether it has been everywhere and is back, or at the end where it is to stop there: pure, for the tests. */
export function roundOf(start: number, length: number, way: 1 | 2 = 2): (now: number) => boolean {
  let [before, travelled, round] = [start, 0, way * length];
  return (now) => {
    const { far, again } = apart(before, now, length);
    if (again) round = length;
    travelled += far;
    before = now;
    // Of the last step it may be a little beyond.
    return travelled >= round - 1e-6 * length;
  };
}

/** How far from where it began it may have come to rest, as a part of all, to be put there. */
const NEAR = 0.1;

function once(line: Timeline): void {
  const start = line.now();
  const sentAtEnd = start >= line.length();
  if (sentAtEnd) line.seek(0);
  line.toggle();
  const isBack = roundOf(sentAtEnd ? 0 : start, line.length(), sentAtEnd ? 1 : 2);
  let frame = requestAnimationFrame(function look() {
    if (!moving()) return end();
    if (!isBack(line.now())) {
      frame = requestAnimationFrame(look);
      return;
    }
    end();
    if (Math.abs(line.now() - start) < NEAR * line.length()) line.seek(start);
    else line.toggle();
  });
  const stop = inHand(() => {
    if (moving()) line.toggle();
    end();
  });
  function end() {
    cancelAnimationFrame(frame);
    stop();
  }
}

/** Calls back once when somebody takes the page in hand; but for the time line, which stops by its own means. */
export function inHand(then: () => void): () => void {
  const listening = new AbortController();
  const options = { capture: true, signal: listening.signal };
  const taken = ({ target }: Event) => {
    if (!(target instanceof Element && target.closest(".time"))) then();
  };
  addEventListener("pointerdown", taken, options);
  addEventListener(
    "keydown",
    (event) => {
      if (event.key !== " " && event.key !== "Tab") taken(event);
    },
    options,
  );
  return () => listening.abort();
}

/** What there is to say of the curve: at this moment once it has come to rest, and along the way. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { type CurveMorph, curveMorph, curveTime } from "#document/curve/curve";
import type { CurveMorphFacts } from "#wasm/curve";

const REST_MS = 120;
/** While it plays, facts take one part in so many of the time at most. */
const SPARSE = 16;
/** Looks along the way, both ends included. */
export const LOOKS = 25;

/** The facts at the moment, a little behind it; null until they are there. */
export const factsNow = signal<CurveMorphFacts | null>(null);

const looked = signal<{ morph: CurveMorph; looks: CurveMorphFacts[] } | null>(null);

/** Facts at even times, as far as they are known, for the morph that is there. */
export const factsAlong: ReadonlySignal<readonly CurveMorphFacts[]> = computed(() => {
  const known = looked.value;
  return known && known.morph === curveMorph.value ? known.looks : [];
});

function factsAt(morph: CurveMorph, s: number): CurveMorphFacts | null {
  try {
    return morph.facts(s);
  } catch {
    return null;
  }
}

let watchers = 0;
let stop = () => {};

/** Keeps the facts up to date for as long as somebody shows them. Returns the end of it. */
export function watchFacts(): () => void {
  if (watchers++ === 0) stop = start();
  return () => {
    if (--watchers === 0) stop();
  };
}

function start(): () => void {
  let rest: ReturnType<typeof setTimeout> | null = null;
  let last = Number.NEGATIVE_INFINITY;
  let pause = 4 * REST_MS;
  const stopNow = effect(() => {
    const morph = curveMorph.value;
    const s = curveTime.value;
    if (rest) clearTimeout(rest);
    // While it plays something is said now and then.
    const wait = Math.min(REST_MS, Math.max(0, last + pause - performance.now()));
    rest = setTimeout(() => {
      const began = performance.now();
      factsNow.value = morph && morph === curveMorph.peek() ? factsAt(morph, s) : null;
      last = performance.now();
      pause = Math.max(4 * REST_MS, SPARSE * (last - began));
    }, wait);
  });
  let next: ReturnType<typeof setTimeout> | null = null;
  const stopAlong = effect(() => {
    const morph = curveMorph.value;
    if (next) clearTimeout(next);
    if (!morph) return;
    const looks: CurveMorphFacts[] = [];
    const step = () => {
      if (morph !== curveMorph.peek()) return;
      const began = performance.now();
      const found = factsAt(morph, looks.length / (LOOKS - 1));
      if (!found) return;
      looks.push(found);
      looked.value = { morph, looks: [...looks] };
      // Between two looks there is time for frames.
      if (looks.length < LOOKS) next = setTimeout(step, Math.max(16, 3 * (performance.now() - began)));
    };
    next = setTimeout(step, 3 * REST_MS);
  });
  return () => {
    if (rest) clearTimeout(rest);
    if (next) clearTimeout(next);
    stopNow();
    stopAlong();
  };
}

/** The real s at which a family closes, bisected by Frond: shown beside what others proved. */
import { effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { frond } from "#wasm/core";
import { epoch, submit } from "#workers/pool/engine";
import type { Job } from "#workers/pool/protocol";
import { familyMaps } from "../pointer/hover";
import { family, sides } from "../view/view";

interface Critical {
  sides: number;
  /** Proved to be in pieces here .. */
  broken: number;
  /** .. and not here, as far as Frond tells. */
  holds: number;
  done: boolean;
}

/** The least real s > 0 at which a family is in one piece; half for two sides. A theorem. */
export function criticalScale(sides: number): number {
  return frond.criticalScale(sides);
}

const state = signal<Critical | null>(null);
export const critical: ReadonlySignal<Critical | null> = state;

/** Gaps this wide are told from none. */
const EPSILON = 1e-11;
/** Bisected to this width. */
const WIDTH = 1e-9;

/** Answers for the family that is shown, once each. Returns the end of it. */
export function followCritical(): () => void {
  return effect(() => {
    const shown = family.value === "polygon" ? sides.value : null;
    epoch.value;
    untracked(() => {
      if (shown !== null && !(state.peek()?.sides === shown && state.peek()?.done)) submit(bisect(shown));
    });
  });
}

/** One parameter at a time: the next depends on the answer. */
function bisect(n: number): Job<"verdict"> {
  // Around what is proved: a coarse bracket, not the answer.
  const near = criticalScale(n);
  let [low, high] = [0.9 * near, Math.min(0.99, 1.1 * near)];
  let asked: "low" | "high" | "middle" = "low";
  let under = false;
  let over = false;
  state.value = null;
  return {
    channel: "scale",
    priority: () => 12,
    next() {
      if (under || over) return null;
      const s = asked === "low" ? low : asked === "high" ? high : (low + high) / 2;
      const maps = familyMaps(n, [s, 0]);
      if (!maps) return null;
      under = true;
      return { kind: "verdict", maps, epsilon: EPSILON };
    },
    accept(_, { verdict }) {
      under = false;
      const broken = verdict === "disconnected";
      const holds = verdict === "connected" || verdict === "touching";
      // A bracket that is none, or an answer that is none, ends it: nothing is claimed.
      if ((!broken && !holds) || (asked === "low" && !broken) || (asked === "high" && !holds)) {
        over = true;
        return;
      }
      if (asked === "middle") {
        const middle = (low + high) / 2;
        if (broken) low = middle;
        else high = middle;
      }
      asked = asked === "low" ? "high" : "middle";
      over = high - low <= WIDTH;
      if (asked === "middle") state.value = { sides: n, broken: low, holds: high, done: over };
    },
    fail() {
      over = true;
    },
  };
}

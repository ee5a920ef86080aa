/** What is at the parameter that is pointed at: a small picture and a verdict, asked for at low cost. */

import { computed, effect, type ReadonlySignal, signal, untracked } from "@preact/signals";
import { pieceColours } from "#document/colours";
import { mapsAt } from "#document/morph";
import { dark } from "#document/preferences";
import type { Uv } from "#geometry/path";
import type { Connectedness, MapRow } from "#wasm/api";
import { frond } from "#wasm/core";
import { Coalesce } from "#workers/pool/coalesce";
import { cancel, epoch, submit } from "#workers/pool/engine";
import type { Job } from "#workers/pool/protocol";
import { epsilon, shownWindow, view } from "../view/view";

/** CSS pixels. */
export const SIDE = 128;

export type By = "mouse" | "touch" | "keys";

export interface Pointed {
  at: Uv;
  by: By;
}

export interface Seen {
  at: Uv;
  bitmap: ImageBitmap | null;
  answer: Connectedness | null;
  epsilon: number;
}

/** The parameter that is pointed at, or null. */
export const pointed = signal<Pointed | null>(null);
const found = signal<Seen | null>(null);
/** What is known of it; while it moves, of where it was a moment ago. */
export const seen: ReadonlySignal<Seen | null> = found;

/** The system of a family at s; null where it cannot be made. */
export function familyMaps(sides: number, [x, y]: Uv): MapRow[] | null {
  try {
    return frond.familyMaps({ sides }, [x, y]).maps;
  } catch {
    return null;
  }
}

/** The maps at a parameter of what is shown. */
function mapsThere(at: Uv): MapRow[] | null {
  const { family, sides } = view.peek();
  return family === "morph" ? mapsAt(at) : familyMaps(sides, at);
}

const queue = new Coalesce(submit);

/** What the square shows, as a word: views that show the same are the same. */
const edges = computed(() => {
  const { u0, v0, u1, v1 } = shownWindow.value;
  return `${u0} ${v0} ${u1} ${v1}`;
});

/** Answers to what is pointed at. Returns the end of it. */
export function followPointer(): () => void {
  const stop = effect(() => {
    const now = pointed.value;
    epoch.value;
    untracked(() => {
      if (now) queue.request(() => look((pointed.peek() ?? now).at));
      else drop();
    });
  });
  const renew = effect(() => {
    epoch.value;
    untracked(() => queue.reset());
  });
  const leave = effect(() => {
    edges.value;
    // Under a hand that rests there is something else now.
    untracked(() => {
      if (pointed.peek()?.by === "mouse") pointed.value = null;
    });
  });
  return () => {
    stop();
    renew();
    leave();
    cancel("hover");
    queue.reset();
    drop();
  };
}

function drop(): void {
  found.peek()?.bitmap?.close();
  found.value = null;
}

/** First the verdict, then the picture: two slices of one job. */
function look(at: Uv): Job<"verdict" | "picture"> {
  const maps = mapsThere(at);
  const { family: kind, sides } = view.peek();
  const scale = Math.min(2, globalThis.devicePixelRatio || 1);
  const side = Math.round(SIDE * scale);
  const colours = pieceColours(dark.peek() ? "dark" : "light");
  const answer: Seen = { at, bitmap: null, answer: null, epsilon: epsilon.peek() };
  const tasks = maps
    ? [
        {
          kind: "verdict" as const,
          maps,
          epsilon: answer.epsilon,
          ...(kind === "polygon" ? { polygon: { sides, s: at } } : {}),
        },
        {
          kind: "picture" as const,
          maps,
          options: { width: side, height: side, colouring: "map" as const, palette: colours },
        },
      ]
    : [];
  return {
    channel: "hover",
    // Below the coarse locus, above its refinement.
    priority: () => 35,
    next: () => tasks.shift() ?? null,
    accept(_, result) {
      if (result instanceof ImageBitmap) answer.bitmap = result;
      else answer.answer = result as Connectedness;
    },
    // No shape there: that is an answer too.
    fail() {
      answer.answer ??= nothing(maps?.length ?? 0);
    },
    done() {
      if (!pointed.peek()) {
        answer.bitmap?.close();
        return;
      }
      drop();
      found.value = { ...answer, answer: answer.answer ?? nothing(0) };
    },
  };
}

const nothing = (count: number): Connectedness => ({
  verdict: "no-attractor",
  gap: { lower: 0, upper: 0 },
  overlaps: [],
  components: Array.from({ length: count }, (_, i) => i),
  count,
  diameter: 0,
  nodes: 0,
});

import { computed, signal } from "@preact/signals";
import { inputs as morph } from "#compute/inputs";
import { locus, locusWindow } from "#compute/results";
import { announce } from "#document/notice";
import { formatNumber } from "#format/numbers";
import { powerWords, resolutionWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { submit } from "#workers/pool/engine";
import type { Job } from "#workers/pool/protocol";
import css from "../field.module.css";
import { directionWords, narrowed, nearestOther, probes, type Side, uniform } from "./boundary";
import { shownField } from "./shown";
import { epsilon, family, fly, shownWindow, view } from "./view";

/** The side that all of the window is on, once all of it is known. */
const side = computed(() => {
  const field = shownField.value;
  return field && locusWindow.value?.progress === 1 ? uniform(field) : null;
});

const middle = (): Uv => {
  const { u0, v0, u1, v1 } = shownWindow.value;
  return [(u0 + u1) / 2, (v0 + v1) / 2];
};

/** What is known of all the plane: of the morph its whole locus, else what the pyramid has of it. */
const whole = computed(() => {
  const pyramid = locusWindow.value?.pyramid;
  if (family.value === "morph" && view.value.w === 0) return locus.value;
  return pyramid?.read(pyramid.boundsOf(0, { x0: 0, y0: 0, x1: 252, y1: 252 }), 1) ?? null;
});

const target = computed((): Uv | null => {
  const now = side.value;
  const field = whole.value;
  return now && field ? nearestOther(field, middle(), now.side) : null;
});

const going = signal(false);

/** Where the window is all of one colour: which one, in words, and a way to where it ends. */
export function ToBoundary() {
  const now = side.value;
  if (now === null) return null;
  const from = middle();
  const to = target.value;
  const far = to === null ? 0 : Math.hypot(to[0] - from[0], to[1] - from[1]);
  const angle = to === null ? 0 : Math.atan2(to[1] - from[1], to[0] - from[0]);
  return (
    <div class={css["to-boundary"]}>
      <p>{sideWords(now)}</p>
      {to !== null && (
        <button
          type="button"
          class="button"
          disabled={going.value}
          onClick={() => go(from, to, now.side)}
          aria-label={`To the nearest boundary, ${directionWords(from, to)}`}
        >
          <span class={css["to-arrow"]} style={{ rotate: `${-angle}rad` }} aria-hidden="true">
            →
          </span>{" "}
          To the boundary, {far < 0.001 ? powerWords(far) : formatNumber(far, 3)} {directionWords(from, to)}
        </button>
      )}
    </div>
  );
}

function sideWords({ side: which, proved }: { side: Side; proved: boolean }): string {
  if (which === "broken") return "All of this is in pieces, proved.";
  if (proved) return "All of this is in one piece, proved.";
  return `All of this looks whole at ${resolutionWords(epsilon.value)}.`;
}

/** Rounds of closing in: with 16 parts each, as near as numbers go. */
const MOST_ROUNDS = 13;

/** Goes to where the line to the target first changes sides, as exactly as the window needs. */
function go(from: Uv, to: Uv, which: Side): void {
  const { family: kind, w, zoom } = view.peek();
  if (kind !== "morph") {
    // Samples of a family are not asked for one by one: so far away that the sample beyond the boundary is seen.
    fly({ x: to[0], y: to[1], zoom: Math.min(zoom, FAMILY_ZOOM) });
    return;
  }
  going.value = true;
  const close = (a: Uv, b: Uv) => Math.hypot(a[0] - b[0], a[1] - b[1]) * zoom < 0.05;
  const arrive = (a: Uv, b: Uv) => {
    going.value = false;
    fly({ x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, zoom });
    announce("At the boundary.");
  };
  let [a, b] = [from, to];
  let round = 0;
  // Each round hangs on the one before it.
  let asked = false;
  const { from: maps, to: last, options } = morph.peek();
  const job: Job<"states"> = {
    channel: "boundary",
    priority: () => 45,
    next() {
      if (round >= MOST_ROUNDS || close(a, b) || asked) return null;
      asked = true;
      round++;
      const points = probes(a, b).map(([u, v]): Uv => (w === 0 ? [u, v] : [u, v, w]));
      return {
        kind: "states",
        from: maps,
        to: last,
        options: { ...options, epsilon: epsilon.peek() },
        points,
      };
    },
    accept(_, states) {
      asked = false;
      [a, b] = narrowed(a, b, states, which);
    },
    fail() {
      round = MOST_ROUNDS;
      asked = false;
    },
    done: () => arrive(a, b),
  };
  submit(job);
}

/** A step of the whole plane is seen from here. */
const FAMILY_ZOOM = 40;

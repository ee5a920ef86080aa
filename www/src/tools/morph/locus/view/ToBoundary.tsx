import { computed, signal } from "@preact/signals";
import { inputs as morph } from "#compute/inputs";
import { locus, locusWindow } from "#compute/results";
import { announce, notify } from "#document/notice";
import { formatNumber } from "#format/numbers";
import { powerWords, resolutionWords } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { submit } from "#workers/pool/engine";
import type { Job } from "#workers/pool/protocol";
import css from "../field.module.css";
import * as messages from "../messages";
import { BoundarySearch, directionWords, othersOf, type Side, sideWords, uniform } from "./boundary";
import { epsilon, family, fly, shownField, shownWindow, view } from "./view";

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

const others = computed((): readonly Uv[] => {
  const now = side.value;
  const field = whole.value;
  return now && field ? othersOf(field, middle(), now.side) : [];
});

const going = signal(false);

/** Where the window is all of one colour: which one, in words, and a way to where it ends. */
export function ToBoundary() {
  const now = side.value;
  if (now === null) return null;
  const from = middle();
  const to = others.value[0] ?? null;
  const far = to === null ? 0 : Math.hypot(to[0] - from[0], to[1] - from[1]);
  const angle = to === null ? 0 : Math.atan2(to[1] - from[1], to[0] - from[0]);
  return (
    <div class={css["to-boundary"]}>
      <p>{sideWords(now, epsilon.value)}</p>
      {to !== null && (
        <button
          type="button"
          class="button"
          disabled={going.value}
          onClick={() => go(from, others.peek(), now.side)}
          aria-label={messages.nearestBoundary(directionWords(from, to))}
        >
          <span class={css["to-arrow"]} style={{ rotate: `${-angle}rad` }} aria-hidden="true">
            →
          </span>{" "}
          {messages.toBoundary(
            far < 0.001 ? powerWords(far) : formatNumber(far, 3),
            directionWords(from, to),
          )}
        </button>
      )}
    </div>
  );
}

/** Goes to where the way to the nearest other sample first changes sides, as exactly as the window needs. */
function go(from: Uv, samples: readonly Uv[], which: Side): void {
  const { family: kind, w, zoom } = view.peek();
  const [to] = samples;
  if (!to) return;
  if (kind !== "morph") {
    // Samples of a family are not asked for one by one: so far away that the sample beyond the boundary is seen.
    fly({ x: to[0], y: to[1], zoom: Math.min(zoom, FAMILY_ZOOM) });
    return;
  }
  going.value = true;
  const close = (a: Uv, b: Uv) => Math.hypot(a[0] - b[0], a[1] - b[1]) * zoom < 0.05;
  const search = new BoundarySearch(from, samples, which, close);
  // Each round hangs on the one before it.
  let asked = false;
  const { from: maps, to: last, options } = morph.peek();
  const nearness = epsilon.peek();
  const job: Job<"states"> = {
    channel: "boundary",
    priority: () => 45,
    next() {
      if (asked) return null;
      const places = search.next();
      if (places.length === 0) return null;
      asked = true;
      const points = places.map(([u, v]): Uv => (w === 0 ? [u, v] : [u, v, w]));
      return { kind: "states", from: maps, to: last, options: { ...options, epsilon: nearness }, points };
    },
    accept(_, states) {
      asked = false;
      search.take(states);
    },
    // What cannot be told is on no side.
    fail() {
      asked = false;
      search.take([]);
    },
    done() {
      going.value = false;
      if (search.found) arrive(...search.found, zoom);
      else notify({ kind: "info", text: NOWHERE(resolutionWords(nearness)) });
    },
  };
  submit(job);
}

const NOWHERE = (nearness: string) => messages.noBoundary(nearness);

function arrive(a: Uv, b: Uv, zoom: number): void {
  fly({ x: (a[0] + b[0]) / 2, y: (a[1] + b[1]) / 2, zoom });
  announce(messages.atBorder);
}

/** A step of the whole plane is seen from here. */
const FAMILY_ZOOM = 40;

/** What is known of the moments of a path: where it breaks, and small pictures of it. */

import { computed, effect, untracked } from "@preact/signals";
import { pieceColours } from "#document/colours";
import { fitFor, pathTrack } from "#document/framing";
import { mapsAt, pathPoints } from "#document/morph";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import { endsOf } from "#document/stand-in";
import { shareOf, stateOf, type Told } from "#format/verdict";
import { boxAt } from "#geometry/boxes";
import { type Uv, uvAt } from "#geometry/path";
import { stretches, widestOf } from "#geometry/states";
import type { Colouring, MapRow, Scene } from "#wasm/api";
import { bendsFor } from "#wasm/bend";
import { Coalesce } from "#workers/pool/coalesce";
import { epoch, submit } from "#workers/pool/engine";
import type { Job } from "#workers/pool/protocol";
import { inputs as morph } from "./inputs";
import { EPSILON, type LocusInputs } from "./locus/job";
import { leavesPlane } from "./plan";
import { outdated, publish } from "./results";

export const FRAMES = 13;
/** CSS pixels. */
export const FRAME_WIDTH = 96;
export const FRAME_HEIGHT = 72;
const MARGIN = 4;

/** Samples of the path between two frames, and in one slice. */
const BETWEEN = 20;
const SLICE = 16;
const SETTLE_MS = 90;

/** What is said of a moment that could not be judged. */
const UNKNOWN: Told = { verdict: "undecided", gap: { lower: 0, upper: Number.NaN }, diameter: 1 };

/** Judges the whole path sample by sample: its broken stretches, and the frames of the strip. */
export function scheduleBreaks(): void {
  const queue = new Coalesce(submit);
  effect(() => {
    epoch.value;
    untracked(() => queue.reset());
  });
  effect(() => {
    const inputs = morph.value;
    const points = pathPoints.value;
    epoch.value;
    untracked(() => queue.request(() => breaksJob(inputs, points)));
  });
}

function breaksJob(inputs: LocusInputs, points: Uv[]): Job<"along"> {
  const count = (FRAMES - 1) * BETWEEN + 1;
  const even = Array.from({ length: count }, (_, i) => uvAt(points, i / (count - 1)));
  const all = [...even, ...points.slice(1, -1)];
  const told: Told[] = all.map(() => UNKNOWN);
  const firsts = new Map<object, number>();
  let from = 0;
  return {
    channel: "breaks",
    // In the plane w = 0 the locus says as much, and sooner: what is said moment by moment waits for it.
    priority: () => (leavesPlane(points) ? 30 : 14),
    next() {
      if (from >= all.length) return null;
      const options = { ...inputs.options, epsilon: EPSILON };
      const at = all.slice(from, from + SLICE);
      const task = { kind: "along" as const, from: inputs.from, to: inputs.to, options, points: at };
      firsts.set(task, from);
      from += at.length;
      return task;
    },
    accept(task, result) {
      told.splice(firsts.get(task) ?? 0, result.length, ...result);
    },
    // Samples that could not be judged count as undecided, not as broken.
    fail() {},
    done() {
      if (points !== pathPoints.peek() || inputs !== morph.peek()) return;
      const moments = told.slice(0, count);
      const states = Uint8Array.from(moments, (moment) => stateOf(moment));
      publish.along.value = {
        points,
        states,
        told: moments,
        ways: told.slice(count),
        breaks: stretches(states),
        worst: widestOf(states, moments.map(shareOf)),
      };
      setFrames((frame, i) => ({ ...frame, verdict: moments[i * BETWEEN] ?? null }));
    },
  };
}

// Of the document these two: the strip does not begin anew with each moment.
const colouring = computed(() => scene.value.colouring);
const colours = computed(() => pieceColours(dark.value ? "dark" : "light"));

/** The film strip: small pictures of the morph at even times. */
export function scheduleStrip(): void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  let shapes = "";
  let last: Pick<What, "inputs" | "points"> | null = null;
  setFrames((frame) => frame);
  effect(() => {
    const what = {
      inputs: morph.value,
      points: pathPoints.value,
      colouring: colouring.value,
      colours: colours.value,
    };
    epoch.value;
    untracked(() => {
      const before = shapes;
      shapes = namesOf(scene.peek());
      const coloured = last?.inputs === what.inputs && last.points === what.points;
      last = what;
      setFrames((frame) => outdated(frame, shapes !== before, coloured));
      if (timer) clearTimeout(timer);
      const begin = (bends?: WebAssembly.Module) => last === what && submit(stripJob({ ...what, bends }));
      timer = setTimeout(() => bendsFor(what)?.then(begin, () => begin()) ?? begin(), SETTLE_MS);
    });
  });
}

interface What {
  inputs: LocusInputs;
  points: Uv[];
  colouring: Colouring;
  colours: string[];
  bends?: WebAssembly.Module | undefined;
}

function stripJob({ inputs, points, colouring, colours, bends }: What): Job<"picture"> {
  const dpr = Math.min(2, globalThis.devicePixelRatio || 1);
  const size = { width: Math.round(FRAME_WIDTH * dpr), height: Math.round(FRAME_HEIGHT * dpr) };
  const edge = MARGIN * dpr;
  const insets = { top: edge, right: edge, bottom: edge, left: edge };
  const track = pathTrack.peek();
  const order = frameTimes().map((_, i) => i);
  const places = new Map<object, number>();
  return {
    channel: "strip",
    // Behind the locus, which follows the hand.
    priority: () => 13,
    next() {
      const i = order.shift();
      if (i === undefined) return null;
      const t = i / (FRAMES - 1);
      const maps: MapRow[] = mapsAt(uvAt(points, t), inputs.options);
      const task = {
        kind: "picture" as const,
        maps,
        options: { ...size, view: fitFor(boxAt(track, t), size, insets), colouring, palette: colours },
        bends,
      };
      places.set(task, i);
      return task;
    },
    accept(task, bitmap) {
      const place = places.get(task);
      setFrames((frame, i) => (i === place ? { ...frame, bitmap, stale: false } : frame));
    },
    fail(task) {
      // Without an attractor there is nothing to draw, and the frame says so by staying empty.
      const place = places.get(task);
      setFrames((frame, i) => (i === place ? { ...frame, bitmap: null, stale: false } : frame));
    },
  };
}

/** What tells shapes from others: while one is changed by hand it keeps its name. */
export function namesOf(scene: Scene): string {
  const { a, b } = endsOf(scene);
  return `${a.name}\n${b.name}`;
}

type StripFrame = (typeof publish.strip.value)[number];

function frameTimes(): number[] {
  return Array.from({ length: FRAMES }, (_, i) => i / (FRAMES - 1));
}

function setFrames(change: (frame: StripFrame, index: number) => StripFrame): void {
  const before = publish.strip.peek();
  publish.strip.value = frameTimes().map((t, i) =>
    change(before[i] ?? { t, verdict: null, bitmap: null, stale: true }, i),
  );
}

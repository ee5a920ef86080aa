/** What was chosen last stays for the visit. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import type { Easing } from "#geometry/pace";
import type { Repeat } from "#wasm/api";
import { filmTask } from "#workers/film/client";
import type { Encodable } from "#workers/film/encode";
import { lasting, type Samples } from "#workers/film/subject";
import * as messages from "./messages";
import { bitrateOf, canBeClear, even, isVideo, type Plan } from "./plan";
import type { NamedSize } from "./SizeFields";
import type { SeedName } from "./seed";
import type { FilmSubject } from "./subject";

export const SIZES: readonly NamedSize[] = [
  { id: "small", name: messages.small480270, width: 480, height: 270 },
  { id: "medium", name: messages.medium854480, width: 854, height: 480 },
  { id: "hd", name: messages.hd1280720, width: 1280, height: 720 },
  { id: "full", name: messages.fullHd19201080, width: 1920, height: 1080 },
  { id: "4k", name: "4K, 3840 × 2160", width: 3840, height: 2160 },
  { id: "square", name: messages.square720720, width: 720, height: 720 },
  { id: "upright", name: messages.portrait7201280, width: 720, height: 1280 },
];

/** Fewer cores would be at it for long. */
const MANY_CORES = 8;

const chosen = signal<Omit<Plan, "from" | "to" | "easing" | "hold" | "samples" | "photograph">>({
  kind: "mp4",
  width: 854,
  height: 480,
  fps: 30,
  quality: "good",
  fullColour: false,
  ground: null,
  clear: false,
  dither: null,
  captions: false,
  inset: false,
});
/** What this browser can write at the chosen size; null until it has told. */
export const able = signal<Encodable | null>(null);
/** null: the whole time line. */
const part = signal<{ from: number; to: number } | null>(null);
/** Seconds, where a subject takes as long as one likes; null: as long as by itself. */
const length = signal<number | null>(null);
const way = signal<Repeat | null>(null);
/** null: as many as this device has the time for. */
const samples = signal<Samples | null>(null);
const USUAL: Samples = navigator.hardwareConcurrency >= MANY_CORES ? 4 : 1;
/** null: as what is filmed goes by itself. */
const easing = signal<Easing | null>(null);
/** null: as on the stage. */
const photograph = signal<boolean | null>(null);
/** Seconds at each end. */
const hold = signal(0);

/** What a shape in the making begins with. */
const seed = signal<SeedName>("frame");

const offered = signal<readonly FilmSubject[]>([]);
const picked = signal("");

/** What there is to be filmed. */
export const subjects: ReadonlySignal<readonly FilmSubject[]> = offered;

/** The same, from the figure that was chosen, where it begins with one. */
export const begun = (one: FilmSubject): FilmSubject => one.seeds?.begin(seed.value) ?? one;

/** What is filmed. */
export const subject: ReadonlySignal<FilmSubject | null> = computed(() => {
  const first = offered.value.find(({ id }) => id === picked.value) ?? offered.value[0] ?? null;
  const found = first && begun(first);
  const seconds = length.value;
  return found?.anyLength && seconds !== null ? { ...found, ...lasting(found, seconds) } : found;
});

/** The dialog opens: what was chosen before holds where it can. */
export function offer(list: readonly FilmSubject[]): void {
  const before = subject.peek()?.id;
  offered.value = list;
  if (subject.peek()?.id !== before) pick(list[0]?.id ?? "");
}

export function pick(id: string): void {
  picked.value = id;
  part.value = null;
  length.value = null;
  way.value = null;
  easing.value = null;
  hold.value = 0;
  photograph.value = null;
}

const paceless = computed<Omit<Plan, "easing" | "hold">>(() => {
  const { seconds = 0, numbers, choosesSmooth = false } = subject.value ?? {};
  const { from, to } = part.value ?? { from: 0, to: seconds };
  const { kind, ...rest } = chosen.value;
  // Not every subject can be had as numbers.
  const possible = !numbers && (kind === "frames" || kind === "keys") ? "mp4" : kind;
  const wish = samples.value ?? USUAL;
  const fullColour =
    rest.fullColour &&
    isVideo(possible) &&
    able.value?.fullColour === true &&
    !(rest.clear && canBeClear(possible));
  return {
    ...rest,
    fullColour,
    // What is always smooth has four.
    samples: choosesSmooth || wish > 4 ? wish : 4,
    photograph: photograph.value ?? subject.value?.photograph ?? false,
    kind: possible,
    from: Math.min(from, seconds),
    to: Math.min(to, seconds),
  };
});

/** What comes after the end of what is filmed: a part of a loop does not go round. */
export const loop = computed<Repeat>(() => {
  const now = subject.value;
  if (!now) return "once";
  const { from, to } = paceless.value;
  const wish = way.value !== null && now.loops.includes(way.value) ? way.value : now.loop;
  return wish === "round" && (from !== 0 || to !== now.seconds) ? "once" : wish;
});

/** Whether there are ends to stop at: neither numbers nor what goes round has any. */
export const hasEnds: ReadonlySignal<boolean> = computed(
  () => paceless.value.kind !== "frames" && loop.value !== "round",
);

export const plan: ReadonlySignal<Plan> = computed(() => {
  const there = hasEnds.value;
  const own = subject.value?.easing ?? null;
  const wish = easing.value ?? (loop.value === "pingpong" ? own : "linear");
  return {
    ...paceless.value,
    easing: there && own !== null ? (wish ?? "linear") : "linear",
    hold: there ? hold.value : 0,
  };
});

/** How its frames go. On the way back, numbers would be the same once more. */
export const framesGo = computed<Repeat>(() =>
  plan.value.kind === "frames" && loop.value === "pingpong" ? "once" : loop.value,
);

export function choose(change: Partial<Plan>): void {
  const {
    from,
    to,
    width,
    height,
    easing: pace,
    hold: still,
    samples: fine,
    photograph: leaf,
    ...rest
  } = change;
  if (leaf !== undefined) photograph.value = leaf;
  if (still !== undefined) hold.value = still;
  if (fine !== undefined) samples.value = fine;
  if (pace !== undefined) easing.value = pace;
  chosen.value = {
    ...chosen.peek(),
    ...rest,
    ...(width === undefined ? {} : { width: even(width) }),
    ...(height === undefined ? {} : { height: even(height) }),
  };
  const now = plan.peek();
  if (from !== undefined || to !== undefined) part.value = { from: from ?? now.from, to: to ?? now.to };
}

export function chooseLoop(next: Repeat): void {
  way.value = next;
}

export function chooseSeed(next: SeedName): void {
  seed.value = next;
}

export function chooseLength(seconds: number): void {
  length.value = seconds;
  part.value = null;
}

export function chooseAll(): void {
  part.value = null;
}

let asked = 0;

/** Asks the browser. A kind that it cannot write is not chosen any longer. */
export async function askAble(): Promise<void> {
  const ask = ++asked;
  const { width, height, fps } = plan.peek();
  const settings = { width, height, fps, bitrate: bitrateOf(plan.peek()) };
  const nothing = { mp4: false, webm: false, fullColour: false };
  const told =
    typeof VideoEncoder === "undefined"
      ? nothing
      : await filmTask("encodable", settings).catch(() => nothing);
  if (ask !== asked) return;
  able.value = told;
  const { kind } = plan.peek();
  if (isVideo(kind) && !told[kind]) {
    choose({ kind: (["mp4", "webm"] as const).find((other) => told[other]) ?? "gif" });
  }
}

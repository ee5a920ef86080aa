/** What was chosen last stays for the visit. */
import { computed, signal } from "@preact/signals";
import { timeline } from "#document/space/space";
import type { Repeat } from "#wasm/api";
import { spaceTask } from "#workers/space/client";
import type { Encodable } from "#workers/space/export";
import { bitrateOf, even, type Kind, type Plan } from "./plan";

export const SIZES: readonly { id: string; name: string; width: number; height: number }[] = [
  { id: "small", name: "Small, 480 × 270", width: 480, height: 270 },
  { id: "medium", name: "Medium, 854 × 480", width: 854, height: 480 },
  { id: "hd", name: "HD, 1280 × 720", width: 1280, height: 720 },
  { id: "full", name: "Full HD, 1920 × 1080", width: 1920, height: 1080 },
  { id: "square", name: "Square, 720 × 720", width: 720, height: 720 },
  { id: "upright", name: "Upright, 720 × 1280", width: 720, height: 1280 },
];

/** Fewer cores would be at it for long. */
const MANY_CORES = 8;

const chosen = signal<Omit<Plan, "from" | "to">>({
  kind: "mp4",
  width: 854,
  height: 480,
  fps: 30,
  quality: "good",
  smooth: navigator.hardwareConcurrency >= MANY_CORES,
});
/** null: the whole time line. */
const part = signal<{ from: number; to: number } | null>(null);

export const plan = computed<Plan>(() => {
  const seconds = timeline.value?.seconds ?? 0;
  const { from, to } = part.value ?? { from: 0, to: seconds };
  return { ...chosen.value, from: Math.min(from, seconds), to: Math.min(to, seconds) };
});

/** What comes after the end of what is exported: a part of a loop does not go round. */
export const loop = computed<Repeat>(() => {
  const line = timeline.value;
  const { from, to } = plan.value;
  const part = from !== 0 || to !== line?.seconds;
  return line?.loop === "round" && part ? "once" : (line?.loop ?? "once");
});

/** How its frames go. On the way back, numbers would be the same once more. */
export const framesGo = computed<Repeat>(() =>
  plan.value.kind === "frames" && loop.value === "pingpong" ? "once" : loop.value,
);

export function choose(change: Partial<Plan>): void {
  const { from, to, width, height, ...rest } = change;
  chosen.value = {
    ...chosen.peek(),
    ...rest,
    ...(width === undefined ? {} : { width: even(width) }),
    ...(height === undefined ? {} : { height: even(height) }),
  };
  const now = plan.peek();
  if (from !== undefined || to !== undefined) part.value = { from: from ?? now.from, to: to ?? now.to };
}

export function chooseAll(): void {
  part.value = null;
}

/** What this browser can write at the chosen size; null until it has told. */
export const able = signal<Encodable | null>(null);
let asked = 0;

/** Asks the browser. A kind that it cannot write is not chosen any longer. */
export async function askAble(): Promise<void> {
  const ask = ++asked;
  const { width, height, fps } = plan.peek();
  const settings = { width, height, fps, bitrate: bitrateOf(plan.peek()) };
  const nothing = { mp4: null, webm: null };
  const told =
    typeof VideoEncoder === "undefined"
      ? nothing
      : await spaceTask("encodable", settings, { lane: 1 }).catch(() => nothing);
  if (ask !== asked) return;
  able.value = told;
  const { kind } = plan.peek();
  if ((kind === "mp4" || kind === "webm") && told[kind] === null) {
    choose({ kind: (["mp4", "webm"] as Kind[]).find((other) => told[other as "mp4"] !== null) ?? "gif" });
  }
}

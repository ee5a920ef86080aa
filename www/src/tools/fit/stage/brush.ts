/**
 * The brush that says what is leaf and what is not, by mouse, finger or keys. Its places are pixels of the picture, y
 * down.
 */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { announce } from "#document/notice";
import type { Stroke } from "#workers/fit/trace-types";
import * as messages from "../messages";
import { addStroke } from "../work/mask";
import { opened } from "../work/source";
import { cutting } from "./layers";

export type Hand = "move" | "keep" | "remove";

export const hand = signal<Hand>("move");
/** Its width in percent of the picture's longer side. */
export const brushSize = signal(3);
/** Whether a stroke changes what is painted and nothing else: else it is a hint. */
export const exact = signal(false);
/** Where it is: under the pointer, or where keys have moved it. */
export const cursor = signal<{ x: number; y: number } | null>(null);
/** What is being painted. */
export const stroke = signal<Stroke | null>(null);

export const painting: ReadonlySignal<boolean> = computed(() => cutting.value && hand.value !== "move");

export const radius: ReadonlySignal<number> = computed(() => {
  const picture = opened.value;
  return picture ? Math.max(0.5, (brushSize.value / 200) * Math.max(picture.width, picture.height)) : 1;
});

type Place = { x: number; y: number };

const round = (z: number) => Math.round(4 * z) / 4;

export function beginStroke({ x, y }: Place): void {
  const what = hand.peek();
  if (what === "move") return;
  stroke.value = { points: [round(x), round(y)], radius: radius.peek(), what, exact: exact.peek() };
}

/** Goes on to a place; steps that are too small to be seen are left out. */
export function goOn({ x, y }: Place): void {
  const now = stroke.peek();
  if (!now) return;
  const [x0 = x, y0 = y] = now.points.slice(-2);
  if (Math.hypot(x - x0, y - y0) < 0.2 * now.radius) return;
  stroke.value = { ...now, points: [...now.points, round(x), round(y)] };
}

export function endStroke(): void {
  const done = stroke.peek();
  if (!done) return;
  stroke.value = null;
  addStroke(done);
}

export function dropStroke(): void {
  stroke.value = null;
}

/** How far a key moves it, in its radius. */
const STEP = 0.5;

/** Keys of the brush on the focused stage. True when the key was one of them. */
export function brushKey(event: KeyboardEvent): boolean {
  const picture = opened.peek();
  if (!picture || event.ctrlKey || event.metaKey || event.altKey) return false;
  const far = STEP * Math.max(1, radius.peek()) * (event.shiftKey ? 0.2 : 1);
  const way = (
    { ArrowLeft: [-far, 0], ArrowRight: [far, 0], ArrowUp: [0, -far], ArrowDown: [0, far] } as Record<
      string,
      [number, number]
    >
  )[event.key];
  const at = cursor.peek() ?? { x: picture.width / 2, y: picture.height / 2 };
  if (way) {
    const next = {
      x: Math.min(picture.width, Math.max(0, at.x + way[0])),
      y: Math.min(picture.height, Math.max(0, at.y + way[1])),
    };
    cursor.value = next;
    goOn(next);
    return true;
  }
  if (event.key === " ") {
    cursor.value = at;
    if (!event.repeat && !stroke.peek()) {
      beginStroke(at);
      announce(hand.peek() === "keep" ? messages.paintingLeaf : messages.paintingNotLeaf);
    }
    return true;
  }
  if (event.key === "Escape") {
    if (stroke.peek()) dropStroke();
    else hand.value = "move";
    return true;
  }
  return false;
}

export function brushKeyUp(event: KeyboardEvent): void {
  if (event.key === " ") endStroke();
}

/** What the stage of space is up to: for its readouts, for files and for the tests. */

import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { spaceFrame, spaceView } from "#document/space/space";
import type { Size } from "#geometry/coordinates";
import type { PainterBackend } from "#stage/surface/painter";
import type { Pixels } from "#stage/surface/surface";
import * as messages from "../messages";
import { type Painted, type SpacePainter, NOTHING as UNPAINTED } from "./surface/painter";

/** In CSS pixels. */
export const stageSize = signal<Size>({ width: 0, height: 0 });

export const painted = signal<Painted>(UNPAINTED);

const painter = signal<SpacePainter | null>(null);

export function setPainter(now: SpacePainter | null): void {
  painter.value = now;
  // What the last one was up to says nothing about the next.
  if (!now) painted.value = UNPAINTED;
}

/** Whether the complete picture of what there is now is on the stage, as smooth as it gets. */
export const spaceDrawn: ReadonlySignal<boolean> = computed(
  () => spaceFrame.value !== null && spaceView.value !== null && painted.value.settled,
);

/** What is on the stage, read back from whatever drew it. */
export async function spacePixels(): Promise<Pixels & { backend: PainterBackend | null }> {
  const now = painter.peek();
  if (!now) throw new Error(messages.thisPageHasNo);
  return { ...(await now.pixels()), backend: painted.peek().backend };
}

/** The object at a point of the stage, in CSS pixels; null where there is none, or nobody knows yet. */
export function objectUnder(x: number, y: number): number | null {
  const { width, height } = stageSize.peek();
  return painter.peek()?.objectAt(x / Math.max(1, width), y / Math.max(1, height)) ?? null;
}

/** Takes the graphics device away, as a browser may. */
export function loseSpace(): void {
  painter.peek()?.forceLoss();
}

export type Part = "shape" | "bend" | "morph" | "light" | "time";

/** Which part of the panel is open: a way of looking, no part of the document. */
export const part = signal<Part>("shape");

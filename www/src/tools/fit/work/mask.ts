/** From a picture to an outline: the mask, what mends it, and which of its parts is the leaf. */
import { batch, computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { announce, notify, wordsOf } from "#document/notice";
import { fitTask } from "#workers/fit/client";
import type { Component, Masked, Stroke, TraceWarning } from "#workers/fit/trace-types";
import { InTurn, isStopped } from "#workers/lanes/latest";
import * as messages from "../messages";
import { type NearPart, nearPart } from "./near-part";
import { framed, frameOfSize, opened, PICTURE_LANE } from "./source";

export interface Settings {
  /** -1 to 1; 0 is what was found by itself. */
  threshold: number;
  stalk: "keep" | "remove";
  strokes: readonly Stroke[];
}

const PLAIN: Settings = { threshold: 0, stalk: "keep", strokes: [] };

export const settings = signal<Settings>(PLAIN);
export const masked = signal<Masked | null>(null);
/** Which of the parts is fitted: its place in the list. */
export const part = signal(0);
/** In units of the plane, or null while there is none. */
export const traced = signal<Float64Array | null>(null);
export const warnings = signal<readonly TraceWarning[]>([]);
export const masking = signal(false);

/** Whether the outline that is seen is the one that was asked for last. */
export const outlined: ReadonlySignal<boolean> = computed(() => traced.value !== null && !masking.value);

/** What was left out beside it, and may belong to it. */
export const leftOut: ReadonlySignal<NearPart | null> = computed(() => {
  const mask = masked.value;
  const points = traced.value;
  if (!mask || !points || !outlined.value) return null;
  const { x, y, scale } = frameOfSize(mask.width, mask.height);
  const pixels = points.map((z, i) => (i % 2 === 0 ? z / scale + x : mask.height - (z / scale + y)));
  return nearPart(mask, Math.min(part.value, mask.components.length - 1), pixels);
});

/** Strokes that were taken back, the last one last. */
const undone = signal<readonly Stroke[]>([]);

const turn = new InTurn();

export function changeMask(change: (settings: Settings) => Settings): void {
  settings.value = change(settings.peek());
}

export function addStroke(stroke: Stroke): void {
  undone.value = [];
  changeMask((now) => ({ ...now, strokes: [...now.strokes, stroke] }));
}

export function canUndoStroke(): boolean {
  return settings.value.strokes.length > 0;
}

export function canRedoStroke(): boolean {
  return undone.value.length > 0;
}

export function undoStroke(): void {
  const { strokes } = settings.peek();
  const last = strokes.at(-1);
  if (!last) return;
  undone.value = [...undone.peek(), last];
  changeMask((now) => ({ ...now, strokes: strokes.slice(0, -1) }));
  announce(messages.removedLastStroke);
}

export function redoStroke(): void {
  const last = undone.peek().at(-1);
  if (!last) return;
  undone.value = undone.peek().slice(0, -1);
  changeMask((now) => ({ ...now, strokes: [...now.strokes, last] }));
}

/** What was painted on a picture is kept with it. */
const kept = new Map<number, { settings: Settings; part: number }>();

/** What was painted goes along to another picture. */
export function keepFor(id: number, settings: Settings, part: number): void {
  kept.set(id, { settings, part });
}

/** Whose settings they are: whoever leaves the tool and comes back finds them as they were. */
let picture: number | null = null;

/** How often an outline was asked for: the last one is the one that is waited for. */
let asked = 0;

/** Keeps mask and outline up with the picture and the settings. Returns the end of it. */
export function watchMask(): () => void {
  return effect(() => {
    const now = opened.value;
    const id = now?.id ?? null;
    if (id !== picture) {
      if (picture !== null) kept.set(picture, { settings: settings.peek(), part: part.peek() });
      picture = id;
      const last = id === null ? undefined : kept.get(id);
      batch(() => {
        settings.value = last?.settings ?? PLAIN;
        part.value = last?.part ?? 0;
        undone.value = [];
        masked.value = null;
        traced.value = null;
        warnings.value = [];
      });
    }
    if (!now) {
      asked++;
      turn.clear();
      masking.value = false;
      return;
    }
    const wanted = settings.value;
    const chosen = part.value;
    const mine = ++asked;
    masking.value = true;
    turn.ask(async () => {
      await work(now.id, wanted, chosen);
      if (mine === asked) masking.value = false;
    });
  });
}

/** The last mask that was asked for: another part of it needs no other. */
let last: { id: number; settings: Settings } | null = null;

async function work(id: number, wanted: Settings, picked: number): Promise<void> {
  const current = () => opened.peek()?.id === id;
  let chosen = picked;
  try {
    let mask = masked.peek();
    if (!mask || last?.id !== id || last.settings !== wanted) {
      const { threshold, stalk, strokes } = wanted;
      const before = mask?.components[chosen];
      mask = await fitTask("mask", { id, threshold, petiole: stalk, strokes }, { lane: PICTURE_LANE });
      if (!current()) return;
      last = { id, settings: wanted };
      // The part that was picked may have another place in the list now.
      const place = before ? sameComponent(mask.components, before, chosen) : Math.max(0, chosen);
      batch(() => {
        masked.value = mask;
        if (place !== part.peek() && part.peek() === chosen) part.value = place;
      });
      chosen = place;
    }
    if (mask.components.length === 0) {
      batch(() => {
        traced.value = null;
        warnings.value = mask.warnings;
      });
      return;
    }
    const component = Math.min(chosen, mask.components.length - 1);
    const outline = await fitTask("outline", { id, component }, { lane: PICTURE_LANE });
    if (!current()) return;
    const { width, height } = mask;
    const all = mask.warnings;
    batch(() => {
      traced.value = framed(outline.points, frameOfSize(width, height));
      warnings.value = [...all, ...outline.warnings];
    });
  } catch (problem) {
    if (current() && !isStopped(problem)) notify({ kind: "error", text: wordsOf(problem) });
  }
}

/** Where a part is after the mask has changed: the one that covers most of its box; the first if none does. */
export function sameComponent(all: readonly Component[], before: Component, at: number): number {
  // What is largest stays what is largest.
  if (at === 0) return 0;
  let best = 0;
  let most = 0;
  all.forEach(({ box }, i) => {
    const across = Math.min(box[2], before.box[2]) - Math.max(box[0], before.box[0]);
    const up = Math.min(box[3], before.box[3]) - Math.max(box[1], before.box[1]);
    const shared = Math.max(0, across) * Math.max(0, up);
    const area = Math.max(1, (box[2] - box[0]) * (box[3] - box[1]));
    // Of one that is inside a larger one the smaller is nearer to what it was.
    const like = (shared * shared) / area;
    if (like > most) {
      most = like;
      best = i;
    }
  });
  return best;
}

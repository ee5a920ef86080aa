/** “Your fits”: what a person keeps of this tool, in this browser. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { polygonOf } from "#document/curve/polygon";
import { fitDocument } from "#document/fit";
import { newId, reasonOf } from "#document/kept/database";
import { Fits, type KeptFit, thinned } from "#document/kept/fits";
import { announce, notify } from "#document/notice";
import type { CurveShape, Fit } from "#wasm/api";
import { frond } from "#wasm/core";
import * as messages from "../messages";
import { openFit, shapeOf, shownFigures } from "../work/fitting";
import { raw } from "../work/outline";
import { running } from "../work/progress";
import { plainName, source } from "../work/source";
import { withinDone } from "../work/within";
import { croppedPhotograph } from "./photograph";

const store = new Fits();

const listed = signal<readonly KeptFit[] | null>(null);
const told = signal<string | null>(null);

/** Null until they have been read. */
export const rows: ReadonlySignal<readonly KeptFit[] | null> = listed;
/** Why nothing is kept, in words; null while all is well. */
export const trouble: ReadonlySignal<string | null> = told;

/** Does something, and shows what is there then. Whether it was done. */
async function after(work: Promise<unknown>, words = ""): Promise<boolean> {
  try {
    await work;
    listed.value = await store.list();
    told.value = null;
    if (words) announce(words);
    return true;
  } catch (problem) {
    listed.value ??= [];
    told.value = reasonOf(problem);
    return false;
  }
}

/** Reads what is there: another tab may have changed it. */
export const readShelf = (): Promise<boolean> => after(Promise.resolve());

/** The fit that is there, as a link holds it; null while there is none, or a better one is looked for. */
const present = computed(() => {
  const fit = presentFit();
  const done = fitDocument.value.model === "spline" ? withinDone.value : shownFigures.value;
  if (!fit || !done || running.value) return null;
  try {
    return { done, fragment: frond.encodeScene({ ...frond.defaultScene(), tool: "fit", fit }) };
  } catch {
    return null;
  }
});

function presentFit(): Fit | null {
  const { numbers, bytes, smoothing, model } = fitDocument.value;
  if (model === "spline") {
    const done = withinDone.value;
    if (!done) return null;
    const spline = { name: plainName(source.value.name), word: done.word };
    return { mode: "outline", model, numbers, smoothing, ...(bytes !== undefined && { bytes }), spline };
  }
  const done = shownFigures.value;
  if (!done || model !== "closed") return null;
  return { mode: "outline", model, numbers, smoothing, curve: shapeOf(done.curve) };
}

export const canKeep: ReadonlySignal<boolean> = computed(() => present.value !== null);
/** Whether the fit that is there is on the shelf. */
export const isKept: ReadonlySignal<boolean> = computed(() => {
  const fragment = present.value?.fragment;
  return fragment !== undefined && listed.value?.some((row) => row.fragment === fragment) === true;
});

/** Puts the fit that is there on the shelf. */
export async function keepFit(): Promise<void> {
  const now = present.peek();
  if (!now || isKept.peek()) return;
  const { done, fragment } = now;
  const points = done.figures ? raw.peek() : null;
  const row = {
    id: newId(),
    name: plainName(source.peek().name),
    time: Date.now(),
    fragment,
    rms: done.figures?.rms ?? null,
    bytes: done.bytes,
    outline: points && thinned(points),
    photograph: await croppedPhotograph(),
  };
  await after(store.put(row), messages.isKept(row.name));
}

/**
 * What a fragment holds, by the reader of links, and its curve as a closed one; null where that does not take it.
 */
export function fitOf(fragment: string): { fit: Fit; shape: CurveShape } | null {
  try {
    const { scene, problem } = frond.decodeScene(fragment);
    const { fit } = scene;
    if (problem || !fit) return null;
    const { spline } = fit;
    const { word = "" } = spline ?? {};
    const shape = spline ? { name: spline.name, curve: polygonOf(word), spline: word } : fit.curve;
    return shape ? { fit, shape } : null;
  } catch {
    return null;
  }
}

/** On the stage again, in place of what is there. */
export function openKept(row: KeptFit, fit: Fit): void {
  const { outline, photograph } = row;
  const { smoothing } = fit;
  openFit(fit, outline && { outline: Float64Array.from(outline), smoothing, photograph });
  announce(messages.isOnStage(row.name));
}

export const renameKept = (row: KeptFit, name: string) => after(store.rename(row.id, name));

export const pinKept = (row: KeptFit) => after(store.pin(row.id, !row.pinned));

/** Off the shelf; it can be put back. */
export async function removeKept(row: KeptFit): Promise<void> {
  if (!(await after(store.remove(row.id)))) return;
  notify({
    kind: "info",
    text: messages.wasRemoved(row.name),
    action: { label: messages.undo, run: () => void after(store.restore(row), messages.isBack(row.name)) },
  });
}

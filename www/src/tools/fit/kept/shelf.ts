/** “Your fits”: what a person keeps of this tool, in this browser. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { fitDocument } from "#document/fit";
import { newId, reasonOf } from "#document/kept/database";
import { Fits, type KeptFit, thinned } from "#document/kept/fits";
import { announce, notify } from "#document/notice";
import type { CurveShape, Fit } from "#wasm/api";
import { frond } from "#wasm/core";
import { openFit, plainName, running, shapeOf, shownFigures } from "../work/fitting";
import { raw } from "../work/outline";
import { source } from "../work/source";
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

/** The closed curve that is there, as a link holds it; null while there is none, or a better one is looked for. */
const present = computed(() => {
  const done = shownFigures.value;
  const { numbers, smoothing, model } = fitDocument.value;
  if (!done || running.value || model !== "closed") return null;
  try {
    const fit: Fit = { mode: "outline", model, numbers, smoothing, curve: shapeOf(done.curve) };
    return { done, fragment: frond.encodeScene({ ...frond.defaultScene(), tool: "fit", fit }) };
  } catch {
    return null;
  }
});

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
  await after(store.put(row), `${row.name} is kept under “Your fits”.`);
}

/** What a fragment holds, by the reader of links; null where that does not take it. */
export function fitOf(fragment: string): (Fit & { curve: CurveShape }) | null {
  try {
    const { scene, problem } = frond.decodeScene(fragment);
    const curve = scene.fit?.curve;
    return problem || !scene.fit || !curve ? null : { ...scene.fit, curve };
  } catch {
    return null;
  }
}

/** On the stage again, in place of what is there. */
export function openKept(row: KeptFit, fit: Fit): void {
  const { outline, photograph } = row;
  const { smoothing } = fit;
  openFit(fit, outline && { outline: Float64Array.from(outline), smoothing, photograph });
  announce(`${row.name} is on the stage.`);
}

export const renameKept = (row: KeptFit, name: string) => after(store.rename(row.id, name));

export const pinKept = (row: KeptFit) => after(store.pin(row.id, !row.pinned));

/** Off the shelf; it can be put back. */
export async function removeKept(row: KeptFit): Promise<void> {
  if (!(await after(store.remove(row.id)))) return;
  notify({
    kind: "info",
    text: `${row.name} was removed.`,
    action: { label: "Undo", run: () => void after(store.restore(row), `${row.name} is back.`) },
  });
}

import { signal } from "@preact/signals";
import { createRef } from "preact";
import { selection } from "#document/morph";
import { pause } from "#document/playback";
import { replace, scene } from "#document/scene";
import { evidenceOpen } from "#stage/evidence/shown";
import type { End } from "./edits";

/** The end whose shape is being chosen; null while the gallery is closed. */
export const gallery = signal<End | null>(null);

/** Whether the gallery was opened for a new shape, which is where it begins then. */
export const forNew = signal(false);

/** Opens the gallery where a new shape is begun. */
export function askForNew(target: End): void {
  forNew.value = true;
  gallery.value = target;
}

/** Opens the maps of a shape. The evidence, which may lie over them, makes room. */
export function editMaps(target: End): void {
  evidenceOpen.value = false;
  orbitOpen.value = false;
  selection.value = { target, map: 0 };
}

/** Takes a shape in hand, as a whole. */
export function takeWhole(target: End): void {
  evidenceOpen.value = false;
  orbitOpen.value = false;
  selection.value = { target, map: 0, whole: true };
}

/** Whether a point is followed on the stage. */
export const orbitOpen = signal(false);

/** The button that begins it. */
export const FOLLOW = createRef<HTMLButtonElement>();

/** Begins to follow a point, or ends it. The maps of a shape, and the evidence, make room. */
export function toggleOrbit(): void {
  const open = !orbitOpen.peek();
  orbitOpen.value = open;
  if (!open) {
    // It is drawn after the state has changed.
    requestAnimationFrame(() => FOLLOW.current?.focus());
    return;
  }
  evidenceOpen.value = false;
  selection.value = null;
}

/** The buttons that do, by the end whose maps they open. */
export const PENCILS = { a: createRef<HTMLButtonElement>(), b: createRef<HTMLButtonElement>() };

/** Closes the maps, and goes back to the button that opened them. */
export function endEditing(): void {
  const target = selection.peek()?.target;
  selection.value = null;
  if (target) showEnd(target);
  // It is drawn after the state has changed.
  if (target) requestAnimationFrame(() => PENCILS[target].current?.focus());
}

/** The moment at which the stage shows an end: what was edited is seen. */
function showEnd(end: End): void {
  pause();
  const t = end === "a" ? 0 : 1;
  const now = scene.peek();
  if (now.t !== t) replace({ ...now, t });
}

/** Whether the list of pairs is open, and in it the other ways to match, and the ways across. */
export const pairsOpen = signal(false);
export const matchingOpen = signal(false);
export const routesOpen = signal(false);

/** Opens the other ways to match, and goes there. */
export function openMatching(): void {
  pairsOpen.value = true;
  matchingOpen.value = true;
  goTo("matching");
}

/** Opens the ways across, and goes there. */
export function openRoutes(): void {
  pairsOpen.value = true;
  routesOpen.value = true;
  goTo("routes");
}

function goTo(id: string): void {
  // It is drawn after the state has changed.
  requestAnimationFrame(() => {
    const summary = document.getElementById(id)?.querySelector<HTMLElement>("summary");
    const panel = summary?.closest<HTMLElement>(".side");
    if (!summary || !panel) return;
    summary.focus({ preventScroll: true });
    panel.scrollTop += summary.getBoundingClientRect().top - panel.getBoundingClientRect().top;
  });
}

/** The panel of evidence in the document, and what opens it: that has the focus again when it closes. */
export const PANEL_ID = "evidence";
export const CHIP_ID = "verdict-chip";

/** Which part of the plane the stage shows. */
import { computed, type ReadonlySignal, signal } from "@preact/signals";
import { editedNow } from "#document/editing/frame";
import { fitFor, heldBox, pairBox, stageTrack } from "#document/framing";
import { selection } from "#document/morph";
import { reducedMotion } from "#document/preferences";
import { inGesture, scene } from "#document/scene";
import { type Box, blendTracks, boxAt, sameTrack, type Track, union } from "#geometry/boxes";
import type { Size, View } from "#geometry/coordinates";
import { panelInset } from "./evidence/shown";

/** What part of the plane the stage shows; null fits the whole attractor. */
export const view = signal<View | null>(null);

/** The size of one picture on the stage, in CSS pixels; 0 by 0 until it is laid out. */
export const stageSize = signal<Size>({ width: 0, height: 0 });

/** Free on each side as a part of the shorter one, and below as many pixels more: the verdict stands there. */
const MARGIN = 0.06;
export const FOOT = 44;
const GRIP = 16;
/** The track that the fit shows: it follows the document, but not while something is dragged, and without a jump. */
const fitted = signal<Track | null>(null);
const t = computed(() => scene.value.t);

/** The view that fits the present moment to the stage. */
export const fitView: ReadonlySignal<View> = computed(() =>
  // What was zoomed by hand is measured by the whole stage, and stays where it is.
  fitOnStage(
    withHeld(boxAt(fitted.value ?? stageTrack.value, t.value)),
    view.value ? 0 : panelInset(stageSize.value.width),
    // The grips of the lowest maps are as large as a finger, and stay above the verdict.
    selection.value ? FOOT + GRIP : FOOT,
  ),
);

/** What is fitted does not move while something is dragged, but grows where the shape at a waypoint would leave it. */
const withHeld = (box: Box): Box => (heldBox.value ? union([box, heldBox.value]) : box);

/** The view that fits both ends: zooms are kept relative to it, so that a link means the same at every moment. */
export const baseView: ReadonlySignal<View> = computed(() => fitOnStage(pairBox.value));

/** The view that fits a box to the stage, with so much free at its sides. */
export function fitOnStage(box: Box, left = 0, foot = FOOT): View {
  const size = sizeOr(stageSize.value);
  const edge = MARGIN * Math.min(size.width, size.height);
  return fitFor(box, size, { top: edge, right: edge, bottom: edge + foot, left: edge + left });
}

/** The view that is drawn. */
export const effectiveView: ReadonlySignal<View> = computed(() => view.value ?? fitView.value);

/** Whether something that is edited lies off the stage. */
export const outOfView: ReadonlySignal<boolean> = computed(() => {
  const all = editedNow.value;
  if (!all || inGesture.value) return false;
  const { x, y, scale } = effectiveView.value;
  const { width, height } = sizeOr(stageSize.value);
  const [across, up] = [width / 2 / scale, height / 2 / scale];
  return all.x0 < x - across || all.x1 > x + across || all.y0 < y - up + FOOT / scale || all.y1 > y + up;
});

/** How much larger than the fit the picture is shown: 1 is the fit. */
export const zoom: ReadonlySignal<number> = computed(() => effectiveView.value.scale / fitView.value.scale);

function sizeOr(size: Size): Size {
  return size.width > 0 && size.height > 0 ? size : { width: 1, height: 1 };
}

const EASE_MS = 220;
/** A tool may keep what is fitted after a drag, where it sees all of another box, too. */
export const afterDrag: { keeps: ((fit: Box, box: Box) => boolean) | null } = { keeps: null };

/** Keeps the fitted track on its way to where it should be. Returns the end of it. */
export function followFit(start: (tick: (now: number) => boolean) => () => void): () => void {
  let stop = () => {};
  let dragged = false;
  const unsubscribe = computed(() => ({ track: stageTrack.value, held: inGesture.value })).subscribe(
    ({ track, held }) => {
      const from = fitted.peek();
      if (held && from) {
        dragged = true;
        return;
      }
      const kept = dragged && from && afterDrag.keeps?.(boxAt(from, t.peek()), boxAt(track, t.peek()));
      dragged = false;
      if (kept) return;
      stop();
      if (!from || reducedMotion.peek() || view.peek()) {
        fitted.value = track;
        return;
      }
      if (sameTrack(from, track)) return;
      let began: number | null = null;
      stop = start((now) => {
        began ??= now;
        const s = Math.min(1, (now - began) / EASE_MS);
        fitted.value = blendTracks(from, track, s * s * (3 - 2 * s));
        return s < 1;
      });
    },
  );
  return () => {
    stop();
    unsubscribe();
  };
}

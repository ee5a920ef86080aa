/** What part of the plane the stage of the fit shows. It glides to what is to be seen, and never jumps. */
import { computed, effect, type ReadonlySignal, signal } from "@preact/signals";
import { fitFor } from "#document/framing";
import { reducedMotion } from "#document/preferences";
import type { Box } from "#geometry/boxes";
import { panned, type Screen, type Size, screen, toWorld, type View, zoomed } from "#geometry/coordinates";
import { outlineBox } from "../work/outline";
import { opened } from "../work/source";
import { cutting } from "./layers";

export const stageSize = signal<Size>({ width: 0, height: 0 });

/** What was panned or zoomed to; null shows all. */
export const view = signal<View | null>(null);

const MARGIN = 0.06;
const FOOT = 44;
const GLIDE_MS = 240;
const UNIT: Box = { x0: -1, y0: -1, x1: 1, y1: 1 };

/** All of the picture while it is cut out, else the outline. */
const wanted: ReadonlySignal<Box | null> = computed(() => {
  const picture = opened.value;
  if (picture && (cutting.value || !outlineBox.value)) {
    const most = Math.max(picture.width, picture.height, 1);
    const [x, y] = [picture.width / most, picture.height / most];
    return { x0: -x, y0: -y, x1: x, y1: y };
  }
  return outlineBox.value;
});

const box = signal<Box>(UNIT);
const glide = signal<{ from: View; s: number } | null>(null);

export const fitView: ReadonlySignal<View> = computed(() => {
  const { width, height } = stageSize.value;
  const size = width > 0 && height > 0 ? { width, height } : { width: 1, height: 1 };
  const edge = MARGIN * Math.min(size.width, size.height);
  return fitFor(box.value, size, { top: edge, right: edge, bottom: edge + FOOT, left: edge });
});

export const effectiveView: ReadonlySignal<View> = computed(() => {
  if (view.value) return view.value;
  const now = glide.value;
  return now ? between(now.from, fitView.value, now.s) : fitView.value;
});

export const zoom: ReadonlySignal<number> = computed(() => effectiveView.value.scale / fitView.value.scale);

/** A view on the way from one to another: what is in the middle moves evenly in the picture. */
export function between(from: View, to: View, s: number): View {
  const scale = from.scale * (to.scale / from.scale) ** s;
  // Where scales differ, as much of the way is gone as the scale has gone of its own.
  const ratio = to.scale / from.scale;
  const share = Math.abs(ratio - 1) < 1e-6 ? s : (1 - ratio ** -s) / (1 - 1 / ratio);
  return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y), scale };
}

/** Keeps the camera on what is to be seen. Returns the end of it. */
export function watchCamera(): () => void {
  let frame = 0;
  let seen = "";
  const stop = effect(() => {
    const to = wanted.value;
    const size = stageSize.value;
    if (!to || size.width === 0) return;
    const key = Object.values(to)
      .map((x) => x.toFixed(4))
      .join();
    if (key === seen) return;
    const first = seen === "";
    seen = key;
    const from = effectiveView.peek();
    box.value = to;
    view.value = null;
    cancelAnimationFrame(frame);
    if (first || reducedMotion.peek()) {
      glide.value = null;
      return;
    }
    glide.value = { from, s: 0 };
    let began: number | null = null;
    const step = (now: number) => {
      began ??= now;
      const s = Math.min(1, (now - began) / GLIDE_MS);
      glide.value = s < 1 ? { from, s: s * s * (3 - 2 * s) } : null;
      if (s < 1) frame = requestAnimationFrame(step);
    };
    frame = requestAnimationFrame(step);
  });
  return () => {
    stop();
    cancelAnimationFrame(frame);
    glide.value = null;
  };
}

export function fitStage(): void {
  view.value = null;
}

export function panBy(dx: number, dy: number): void {
  view.value = panned(effectiveView.peek(), dx, dy);
}

export function zoomBy(factor: number, about?: Screen): void {
  const size = stageSize.peek();
  const at = about ?? screen(size.width / 2, size.height / 2);
  view.value = zoomed(effectiveView.peek(), factor, at, size, fitView.peek().scale);
}

/** The point of the plane under a point of the stage. */
export function under(at: Screen): { x: number; y: number } {
  return toWorld(at, effectiveView.peek(), stageSize.peek());
}

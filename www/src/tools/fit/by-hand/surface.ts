/** A canvas that fills its place, in CSS pixels. */
import type { Signal } from "@preact/signals";
import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";
import type { Size } from "#geometry/coordinates";

/** Keeps the size of an element in `box`. */
export function useBox(root: RefObject<HTMLElement | null>, box: Signal<Size>): void {
  useLayoutEffect(() => {
    const element = root.current;
    if (!element) return;
    const measure = () => {
      box.value = { width: element.clientWidth, height: element.clientHeight };
    };
    const watch = new ResizeObserver(measure);
    watch.observe(element);
    measure();
    return () => watch.disconnect();
  }, [root, box]);
}

/** An empty canvas of that size, as fine as the screen; null where there is nothing to draw on. */
export function emptied(canvas: HTMLCanvasElement | null, { width, height }: Size) {
  const context = canvas?.getContext("2d");
  if (!canvas || !context || width === 0) return null;
  const ratio = Math.min(3, globalThis.devicePixelRatio || 1);
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

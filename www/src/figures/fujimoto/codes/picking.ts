import type { Point } from "../../kit/maps/pieces";
import css from "./picking.module.css";

/** For what is pressed. */
export const pickedClass = css["picked"] ?? "";

/**
 * Makes a drawing answer to the pointer: where it is pressed, and where it is dragged, in parts of its width and
 * height.
 */
export function picking(onPick: (at: Point) => void) {
  const pick = (event: PointerEvent) => {
    const box = (event.currentTarget as Element).getBoundingClientRect();
    const within = (x: number) => Math.min(1, Math.max(0, x));
    onPick([
      within((event.clientX - box.left) / box.width),
      within(1 - (event.clientY - box.top) / box.height),
    ]);
  };
  return {
    onPointerDown(event: PointerEvent) {
      if (event.button !== 0) return;
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      pick(event);
    },
    onPointerMove(event: PointerEvent) {
      if ((event.currentTarget as Element).hasPointerCapture(event.pointerId)) pick(event);
    },
  };
}

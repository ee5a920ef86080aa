import { useRef } from "preact/hooks";

/** What an element needs to be dragged: by how many pixels since the last call. */
export function useDrag(onDrag: (dx: number, dy: number) => void) {
  const last = useRef<{ x: number; y: number } | null>(null);
  return {
    onPointerDown(event: PointerEvent) {
      if (event.button !== 0) return;
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      last.current = { x: event.clientX, y: event.clientY };
    },
    onPointerMove(event: PointerEvent) {
      if (!last.current || !(event.currentTarget as Element).hasPointerCapture(event.pointerId)) return;
      const [dx, dy] = [event.clientX - last.current.x, event.clientY - last.current.y];
      last.current = { x: event.clientX, y: event.clientY };
      onDrag(dx, dy);
    },
  };
}

import { useRef } from "preact/hooks";
import type { SpaceView } from "#wasm/api";
import { orbited } from "./eye";

/** Radians for a key press, and for a pixel. */
const STEP = Math.PI / 36;
const EACH = 0.008;
/** An eye that is held sees little: it turns less. */
const HELD = -0.3;

const KEYS: Readonly<Record<string, readonly [turn: number, tilt: number]>> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, STEP],
  ArrowDown: [0, -STEP],
};

/** What a canvas needs to be looked at from all sides, by hand and by keys. */
export function useOrbit(view: SpaceView, onView: ((view: SpaceView) => void) | undefined) {
  const last = useRef<{ x: number; y: number } | null>(null);
  if (!onView) return {};
  const turn = (by: number, tilt: number) => {
    const side = view.holds === "eye" ? HELD : 1;
    onView(orbited(view, side * by, side * tilt));
  };
  return {
    tabIndex: 0,
    onPointerDown(event: PointerEvent) {
      if (event.button !== 0) return;
      (event.currentTarget as Element).setPointerCapture(event.pointerId);
      last.current = { x: event.clientX, y: event.clientY };
    },
    onPointerMove(event: PointerEvent) {
      if (!last.current || !(event.currentTarget as Element).hasPointerCapture(event.pointerId)) return;
      const [dx, dy] = [event.clientX - last.current.x, event.clientY - last.current.y];
      last.current = { x: event.clientX, y: event.clientY };
      turn(-EACH * dx, EACH * dy);
    },
    onKeyDown(event: KeyboardEvent) {
      const by = KEYS[event.key];
      if (!by || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      turn(...by);
    },
  };
}

/** What it is to those who hear it. */
export function orbitLabel(label: string, turned: boolean) {
  return turned
    ? { role: "application" as const, "aria-label": `${label}. Arrow keys look at it from another side.` }
    : { role: "img" as const, "aria-label": label };
}

import type { SpaceView } from "#wasm/api";
import { useDrag } from "../../kit/picture/drag";
import { orbited } from "./eye";

/** Radians for a key press, and for a pixel. */
const STEP = Math.PI / 36;
const PER_PIXEL = 0.008;
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
  const turn = (by: number, tilt: number) => {
    const side = view.holds === "eye" ? HELD : 1;
    onView?.(orbited(view, side * by, side * tilt));
  };
  const drag = useDrag((dx, dy) => turn(-PER_PIXEL * dx, PER_PIXEL * dy));
  if (!onView) return {};
  return {
    tabIndex: 0,
    ...drag,
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

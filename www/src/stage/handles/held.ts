/** What is held by its parallelogram, the image of a box under a map: how drags and keys change that map. */
import { signal } from "@preact/signals";
import { announce } from "#document/notice";
import { lengthWords } from "#format/verdict";
import type { Box } from "#geometry/boxes";
import { type Screen, screen, toScreen, toWorld, type World } from "#geometry/coordinates";
import { mapWords } from "#geometry/maps/affine2";
import { type Corners, cornersOf, dragged, type Grip, turned } from "#geometry/parallelogram";
import { type Rests, snapped, spun } from "#geometry/snap";
import type { MapRow } from "#wasm/api";
import { useGrip } from "../grip";
import * as messages from "../messages";
import { effectiveView, stageSize } from "../view";

export interface Held {
  /** "Map 2", as people are told of it. */
  name: string;
  /** Names its gestures. */
  id: string;
  map: () => MapRow | null;
  /** The box whose image it is. */
  box: () => Box;
  rests: () => Rests;
  /** Another map in its place; a run of changes is one step of undo. */
  change: (to: (map: MapRow) => MapRow, gesture: string) => void;
}

const STEP = 10;
const FINE = 1;
/** How near, in CSS pixels, what is dragged has to come to rest at something. */
const REACH = 8;
/** By how much a key turns it, in degrees. */
const TURN = 5;

/** What each of its grips does. */
export const DOES: Record<Grip, string> = {
  origin: messages.moves,
  x: messages.firstSide,
  y: messages.secondSide,
  turn: messages.turnsAndScales,
};

/** Whether what is dragged comes to rest at the other maps. Alt does the opposite. */
export const snapping = signal(true);
/** Where it rests just now. */
export const rest = signal<World | null>(null);

/** Which way an arrow key goes on the screen. */
export const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Whether a key is for the browser. */
export const foreign = ({ ctrlKey, metaKey, altKey }: KeyboardEvent) => ctrlKey || metaKey || altKey;

/** Drags and arrow keys for one of its grips; `take` where it is to be chosen first. */
export const useHeldGrip = (held: Held, grip: Grip, take?: () => void) =>
  useGrip({
    take(event) {
      event.stopPropagation();
      take?.();
      return placeOf(held, grip);
    },
    moveTo: (to, free) => moveTo(held, grip, to, `drag ${held.id} ${grip}`, free !== snapping.peek()),
    key(event) {
      if (take && (event.key === "Enter" || event.key === " ")) {
        take();
        return true;
      }
      const step = ARROWS[event.key];
      const at = placeOf(held, grip);
      // What has the focus is what keys mean, and so what is chosen.
      if ((event.key === "Delete" || event.key === "Backspace") && !foreign(event)) take?.();
      if (!step || !at || foreign(event)) return false;
      take?.();
      const far = event.shiftKey ? FINE : STEP;
      moveTo(held, grip, { x: at.x + far * step[0], y: at.y + far * step[1] }, `keys ${held.id} ${grip}`);
      const map = held.map();
      if (!map) return true;
      const { x, y } = cornersOf(map, held.box())[grip];
      announce(`${held.name}, ${DOES[grip]}: ${lengthWords(x)}, ${lengthWords(y)}`);
      return true;
    },
  });

/** The same for the handle that only turns it, which stands at `place`. */
export const useHeldTurner = (held: Held, place: (corners: Corners) => Screen) =>
  useGrip({
    take(event) {
      event.stopPropagation();
      const map = held.map();
      return map && place(cornersOf(map, held.box()));
    },
    moveTo(to, free) {
      const point = toWorld(to, effectiveView.peek(), stageSize.peek());
      rest.value = null;
      held.change((map) => spun(map, held.box(), point, free === snapping.peek()), `turn ${held.id}`);
    },
    key(event) {
      const [x = 0, y = 0] = ARROWS[event.key] ?? [];
      if ((x === 0 && y === 0) || foreign(event)) return false;
      const by = ((event.shiftKey ? 1 : TURN) * (x > 0 || y > 0 ? -1 : 1) * Math.PI) / 180;
      const { scale } = effectiveView.peek();
      held.change((map) => rounded(turned(map, held.box(), by), scale), `turn keys ${held.id}`);
      const map = held.map();
      if (map) announce(`${held.name}: ${mapWords(map)}`);
      return true;
    },
  });

function placeOf(held: Held, grip: Grip): Screen | null {
  const map = held.map();
  return map ? toScreen(cornersOf(map, held.box())[grip], effectiveView.peek(), stageSize.peek()) : null;
}

function moveTo(held: Held, grip: Grip, to: { x: number; y: number }, gesture: string, rests = false) {
  const view = effectiveView.peek();
  const point = toWorld(screen(to.x, to.y), view, stageSize.peek());
  held.change((map) => {
    const box = held.box();
    if (rests) {
      const found = snapped(map, box, grip, point, held.rests(), REACH / view.scale);
      rest.value = found.at;
      // What rests is exact, and stays so.
      if (found.at) return found.map;
    } else rest.value = null;
    return rounded(dragged(map, box, grip, point), view.scale);
  }, gesture);
}

/** Numbers as fine as a hundredth of a pixel, which keeps links short. */
function rounded(map: MapRow, scale: number): MapRow {
  const digits = Math.min(14, Math.max(3, Math.ceil(Math.log10(100 * scale))));
  return map.map((x) => Number(x.toFixed(digits))) as MapRow;
}

/** The path of the morph as its handles and its editor have it. */
import { computed } from "@preact/signals";
import { uv } from "#document/morph";
import { scene } from "#document/scene";
import type { Uv } from "#geometry/path";
import type { WayPath } from "#stage/locus/WayPoints";
import { MOST_POINTS, scrubTo } from "../../edits";
import { shownWindow, view } from "../view/view";
import {
  addAfter,
  addHere,
  chosen,
  moveTo,
  pick,
  place,
  pointWords,
  removeAt,
  stateNow,
  toneAt,
  way,
  wayWords,
} from "./waypoints";

export const isOutside = ([x, y]: readonly [number, number]): boolean =>
  !(x >= 0 && x <= 1 && y >= 0 && y <= 1);

/** Points nearer to the slice than this lie in it, as far as anyone sees. */
export const THICKNESS = 0.005;
export const isOff = ([, , w = 0]: Uv, slice: number): boolean => Math.abs(w - slice) > THICKNESS;

const onSquare = (point: Uv) => place(point, shownWindow.value);

export const PATH: WayPath = {
  way,
  chosen,
  most: MOST_POINTS,
  pick,
  moveTo,
  addAfter,
  addHere,
  removeAt,
  moment: computed(() => scene.value.t),
  uv,
  goTo: scrubTo,
  wayWords,
  stateNow,
  toneAt,
  pointWords,
  place: onSquare,
  /** Beyond the edge of the square, or off the slice that it shows. */
  look: (point) =>
    `${isOutside(onSquare(point)) ? "outside" : ""} ${isOff(point, view.value.w) ? "off" : ""}`,
  zoom: () => view.peek().zoom,
};

import type { MapRow, RasterOptions } from "#wasm/api";
import { filmCrew, filmTask } from "./client";
import { painters } from "./crew";
import { stripView } from "./strip";
import type { Drawer, FrameLook } from "./subject";

type View = NonNullable<RasterOptions["view"]>;

/** What there is to be drawn of a moment. */
export interface PlaneMoment {
  maps: MapRow[];
  weights?: number[] | undefined;
  options: Pick<RasterOptions, "colouring" | "palette" | "lightGround" | "bend"> & { view: View };
}

/** Draws attractors of the plane, side by side. */
export function planeDrawer(
  { width, height }: FrameLook,
  alone: boolean,
  at: (seconds: number) => PlaneMoment,
): Drawer {
  const crew = alone ? null : filmCrew();
  const hands = alone ? 1 : painters(4 * width * height);
  let next = 0;
  let before = "";
  let missing = 0;
  const drawn = ({ maps, weights, options }: PlaneMoment, rows: number, signal: AbortSignal) => {
    const request = { maps, weights, options: { ...options, width, height: rows } };
    return crew
      ? crew.task("attractor", request, { signal, lane: next++ % hands })
      : filmTask("attractor", request, { signal });
  };
  const drawer: Drawer = {
    hands,
    get missing() {
      return missing;
    },
    async frame(seconds, signal) {
      const moment = at(seconds);
      const key = JSON.stringify(moment);
      // What stays as it was is not drawn again.
      if (key === before) return null;
      before = key;
      return drawn(moment, height, signal).catch((problem: unknown) => {
        if (signal.aborted || alone) throw problem;
        // Maps without an attractor.
        missing++;
        return null;
      });
    },
    end: () => crew?.end(),
  };
  // How bright a density is depends on all of the picture.
  if (at(0).options.colouring === "density") return drawer;
  return {
    ...drawer,
    get missing() {
      return missing;
    },
    async strip(seconds, rows, signal) {
      const { maps, options } = at(seconds);
      const view = stripView(options.view, height, rows);
      return drawn({ maps, options: { ...options, view } }, rows.count, signal);
    },
  };
}

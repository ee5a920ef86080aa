import type { MapRow, RasterOptions } from "#wasm/api";
import { filmCrew, filmTask } from "./client";
import { painters } from "./crew";
import type { Drawer, FrameLook, FramePixels } from "./subject";

/** What there is to be drawn of a moment. */
export interface PlaneMoment {
  maps: MapRow[];
  options: Pick<RasterOptions, "view" | "colouring" | "palette" | "bend">;
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
  return {
    hands,
    get missing() {
      return missing;
    },
    async frame(seconds, signal): Promise<FramePixels | null> {
      const { maps, options } = at(seconds);
      const key = JSON.stringify([maps, options]);
      // What stays as it was is not drawn again.
      if (key === before) return null;
      before = key;
      const request = { maps, options: { ...options, width, height } };
      const drawn = crew
        ? crew.task("attractor", request, { signal, lane: next++ % hands })
        : filmTask("attractor", request, { signal });
      return drawn.catch((problem: unknown) => {
        if (signal.aborted || alone) throw problem;
        // Maps without an attractor.
        missing++;
        return null;
      });
    },
    end: () => crew?.end(),
  };
}

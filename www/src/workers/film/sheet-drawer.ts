import type { Bend, RasterOptions } from "#wasm/api";
import { filmCrew, filmTask } from "./client";
import { painters } from "./crew";
import type { SheetPicture } from "./plane";
import type { Drawer, FrameLook } from "./subject";

/** Draws a picture that is bent, side by side. */
export function sheetDrawer(
  { width, height }: FrameLook,
  alone: boolean,
  {
    picture,
    parts,
    view,
  }: { picture: SheetPicture; parts: number; view: NonNullable<RasterOptions["view"]> },
  bendAt: (seconds: number) => Bend | null,
): Drawer {
  const crew = alone ? null : filmCrew();
  const hands = alone ? 1 : painters(4 * (width * height + picture.width * picture.height));
  const begun = new Set<number>();
  let next = 0;
  let before = "";
  return {
    hands,
    missing: 0,
    async frame(seconds, signal) {
      const bend = bendAt(seconds);
      const key = JSON.stringify(bend);
      if (key === before) return null;
      before = key;
      const lane = crew ? next++ % hands : 0;
      const options = { width, height, view };
      if (!crew) {
        await filmTask("sheetBegin", picture, { signal });
        return filmTask("sheet", { bend, parts, options }, { signal });
      }
      // A lane does one thing after the other: the picture is there before the first frame.
      const ready = begun.has(lane) ? null : crew.task("sheetBegin", picture, { signal, lane });
      begun.add(lane);
      ready?.catch(() => {});
      return crew.task("sheet", { bend, parts, options }, { signal, lane });
    },
    end: () => crew?.end(),
  };
}

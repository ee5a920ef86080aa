import type { Bend, RasterOptions } from "#wasm/api";
import { filmCrew, filmTask } from "./client";
import { painters } from "./crew";
import type { SheetFrame, SheetPicture } from "./plane";
import { stripView } from "./strip";
import type { Drawer, FrameLook } from "./subject";

type Crew = ReturnType<typeof filmCrew>;

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
  const sheet = (from: Crew, request: SheetFrame, lane: number, signal: AbortSignal) => {
    // A lane does one thing after the other: the picture is there before the first frame.
    const ready = begun.has(lane) ? null : from.task("sheetBegin", picture, { signal, lane });
    begun.add(lane);
    ready?.catch(() => {});
    return from.task("sheet", request, { signal, lane });
  };
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
      return sheet(crew, { bend, parts, options }, lane, signal);
    },
    async strip(seconds, rows, signal) {
      const options = { width, height: rows.count, view: stripView(view, height, rows) };
      const request = { bend: bendAt(seconds), parts, options };
      return crew ? sheet(crew, request, next++ % hands, signal) : filmTask("sheet", request, { signal });
    },
    end: () => crew?.end(),
  };
}

import type { RasterOptions } from "#wasm/api";

type View = NonNullable<RasterOptions["view"]>;

/** What some rows of a picture show, where this is what the whole of so many rows shows. */
export function stripView(view: View, height: number, { top, count }: { top: number; count: number }): View {
  return { ...view, y: view.y + (height / 2 - (top + count / 2)) / view.scale };
}

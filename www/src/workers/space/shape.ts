import type { BoxCount3, MapRow3 } from "#wasm/api";
import { solid } from "#wasm/space";
import type { Context } from "../lanes/task";

export const shapeTasks = {
  /** The dimension, counted in boxes from a million points. */
  boxes: (_context: Context, { maps }: { maps: MapRow3[] }): BoxCount3 => solid.boxes3(maps),
};

/** Pictures that are drawn in strips are those that are drawn at once. */
import { beforeAll, expect, it } from "vitest";
import * as frond from "../../www/pkg/index.js";
import { stripView } from "../../www/src/workers/film/strip";
import { load, shape } from "./frond";

beforeAll(load);

it.each(["map", "address"] as const)("to the last bit, coloured by %s", (colouring) => {
  const view = { x: 0.1, y: 5, scale: 17.3 };
  const [width, height, count] = [150, 130, 37];
  const style = { colouring, palette: ["#e69f00", "#56b4e9", "#009e73", "#f0e442"] };
  const ifs = shape("fern");
  const whole = frond.rasterize(ifs, { width, height, view, ...style });
  expect(whole.some((x) => x > 0)).toBe(true);
  for (let top = 0; top < height; top += count) {
    const rows = { top, count: Math.min(count, height - top) };
    const part = frond.rasterize(ifs, {
      width,
      height: rows.count,
      view: stripView(view, height, rows),
      ...style,
    });
    expect(part).toEqual(whole.slice(4 * width * top, 4 * width * (top + rows.count)));
  }
});

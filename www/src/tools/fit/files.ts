/** Fits of collages as text; `#format/curve-files` has those by closed curves. */

import { GREY } from "#style/colours";
import { palette } from "#style/palette";
import { svgFile, tag } from "#ui/files/svg";
import type { Collage, CollageOptions } from "#workers/fit/curve";
import * as messages from "./messages";

const short = (x: number) => Number(x.toPrecision(9));

export function collageJson(name: string, options: CollageOptions, fit: Collage): string {
  const maps = fit.maps.map(
    ([start = 0, reversed = 0, c11 = 0, c12 = 0, c21 = 0, c22 = 0, bx = 0, by = 0, ex = 0, ey = 0]) => ({
      start,
      reversed: reversed === 1,
      c: [
        [c11, c12],
        [c21, c22],
      ].map((row) => row.map(short)),
      b: [bx, by].map(short),
      e: [ex, ey].map(short),
    }),
  );
  return JSON.stringify(
    {
      kind: "collage (Cochran, Hart & Flynn, section 3.2)",
      name,
      about: messages.pointM0To,
      ...options,
      maps,
      gaps: { unit: messages.percentDiagonalOutlinesBounding, widest: fit.widest, mean: fit.mean },
      figures: fit.figures,
    },
    null,
    1,
  );
}

/** x,y lines, with the number of the piece, from 1. */
export function collageCsv({ points, starts }: Collage): string {
  const lines = ["x,y,piece"];
  for (let k = 0; k + 1 < starts.length; k++) {
    for (let i = starts[k] ?? 0; i < (starts[k + 1] ?? 0); i++) {
      lines.push(`${short(points[2 * i] ?? 0)},${short(points[2 * i + 1] ?? 0)},${k + 1}`);
    }
  }
  return `${lines.join("\n")}\n`;
}

/** A path for each piece, y down as in every SVG. */
export function collageSvg({ points, starts }: Collage): string {
  const paths: string[] = [];
  for (let k = 0; k + 1 < starts.length; k++) {
    const part: string[] = [];
    for (let i = starts[k] ?? 0; i < (starts[k + 1] ?? 0); i++) {
      part.push(`${short(500 * (points[2 * i] ?? 0))} ${short(-500 * (points[2 * i + 1] ?? 0))}`);
    }
    paths.push(tag("path", { d: `M${part.join("L")}` }));
  }
  const stroke = palette("light")[2] ?? GREY;
  const style = { fill: "none", stroke, "stroke-width": 2, "stroke-linejoin": "round" };
  return svgFile({ box: [-550, -550, 1100, 1100], style }, ...paths);
}

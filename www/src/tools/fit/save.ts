/** Files of the fit. */

import { fitDocument } from "#document/fit";
import { fitFor } from "#document/framing";
import { notify, wordsOf } from "#document/notice";
import { dark } from "#document/preferences";
import { curveJson, pointsCsv, splineJson } from "#format/curve-files";
import { BAD, GREY, WHITE } from "#style/colours";
import { palette } from "#style/palette";
import { download, plainName, pngOf } from "#ui/files/download";
import { svgFile, tag } from "#ui/files/svg";
import { rough } from "#wasm/curve";
import type { Collage, CollageOptions } from "#workers/fit/curve";
import * as messages from "./messages";
import { paint } from "./stage/draw";
import { collage, shownFigures, shownFit } from "./work/fitting";
import { polylineOf, prepared } from "./work/outline";
import { boxOf, plainName as nameOf, source } from "./work/source";
import { shownWithin, withinDone } from "./work/within";

// Fits of collages as text; `#format/curve-files` has those by closed curves.

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

const LONG_SIDE = 2400;

/** The curve within bytes, where that is what is fitted. */
const within = () => (fitDocument.peek().model === "spline" ? shownWithin.peek() : null);

const paper = () => {
  const now = collage.peek();
  return fitDocument.peek().model === "collage" && now?.of === prepared.peek() ? now : null;
};

export function saveSvg(): void {
  save("svg", "image/svg+xml", () => {
    const other = paper();
    if (other) return collageSvg(other.fit);
    const spline = within();
    // Its own parabolas, and no others.
    if (spline) return rough.splineSvg(spline.word, undefined);
    const best = shownFit.peek();
    return best && rough.curveSvg(best.curve, undefined);
  });
}

export function saveCsv(): void {
  save("csv", "text/csv", () => {
    const other = paper();
    if (other) return collageCsv(other.fit);
    const spline = within();
    if (spline) return pointsCsv(spline.points);
    const best = shownFit.peek();
    return best && rough.curveCsv(best.curve, undefined);
  });
}

export function saveJson(): void {
  save("json", "application/json", () => {
    const other = paper();
    const name = nameOf(source.peek().name);
    if (other) return collageJson(name, other.options, other.fit);
    const spline = within();
    if (spline) {
      return splineJson(
        name,
        spline.word,
        rough.unpackSpline(spline.word),
        withinDone.peek()?.figures ?? null,
      );
    }
    const best = shownFit.peek();
    return (
      best && curveJson(name, best.curve, rough.curveMaps(best.curve), shownFigures.peek()?.figures ?? null)
    );
  });
}

function save(ending: string, type: string, make: () => string | null): void {
  try {
    const text = make();
    if (text !== null) download(new Blob([text], { type }), fileName(ending));
  } catch (problem) {
    notSaved(problem);
  }
}

/** The fit alone, on a transparent ground. */
export function savePng(): void {
  try {
    const other = paper();
    const best = shownFit.peek();
    const points = other
      ? other.fit.points
      : (within()?.points ?? (best && (polylineOf(best.curve) ?? best.points)));
    if (!points) return;
    const box = boxOf(points);
    const [across, up] = [box.x1 - box.x0, box.y1 - box.y0];
    const larger = LONG_SIDE / Math.max(across, up);
    const size = { width: Math.ceil(across * larger), height: Math.ceil(up * larger), ratio: 2 };
    const canvas = document.createElement("canvas");
    canvas.width = Math.max(1, size.width);
    canvas.height = Math.max(1, size.height);
    const context = canvas.getContext("2d");
    if (!context) throw new Error(messages.noCanvas);
    const fit = palette(dark.peek() ? "dark" : "light")[2] ?? GREY;
    const colours = { stage: WHITE, ink: fit, quiet: fit, fit, bad: BAD, accent: fit, arcs: [] };
    const view = fitFor(box, canvas, 0.02);
    const nothing = {
      photo: null,
      mask: null,
      outline: null,
      filled: false,
      copies: null,
      marks: null,
      strokes: [],
      cursor: null,
    };
    const shown = other ? { fit: null, collage: other.fit } : { fit: points, collage: null };
    paint(
      context,
      size,
      { ...view, scale: view.scale / size.ratio },
      { ...nothing, ...shown, frame: { x: 0, y: 0, scale: 1 } },
      colours,
    );
    pngOf(canvas).then((blob) => download(blob, fileName("png")), notSaved);
  } catch (problem) {
    notSaved(problem);
  }
}

function notSaved(problem: unknown): void {
  notify({ kind: "error", text: messages.fitNotSaved(wordsOf(problem)) });
}

const fileName = (ending: string) => `frond-${plainName(nameOf(source.peek().name), "leaf")}.${ending}`;

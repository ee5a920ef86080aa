/** The curve of the present moment as a file. */

import { sameCurves } from "#document/curve/changes";
import { curveMorph, curves, curveTime } from "#document/curve/curve";
import { photographsSeen } from "#document/curve/photographs";
import { bend } from "#document/deform/bend";
import { notify, wordsOf } from "#document/notice";
import { dark } from "#document/preferences";
import { tool } from "#document/tool";
import { moved } from "#stage/curve/painter";
import { carriedOn } from "#stage/curve/photographs/carried";
import { stillCurve } from "#stage/curve/still";
import { stageStyle } from "#stage/picture-style";
import { effectiveView, stageSize } from "#stage/view";
import { GREY } from "#style/colours";
import { download } from "#ui/files/download";
import { rough } from "#wasm/curve";
import { csvOf, jsonOf, nameOf, svgOf } from "./files";
import * as messages from "./messages";

export type Kind = "svg" | "png" | "csv" | "json";

export const KINDS: readonly { kind: Kind; about: string }[] = [
  { kind: "svg", about: messages.outlineAsPathFor },
  { kind: "png", about: messages.pictureOnStageLarger },
  { kind: "csv", about: messages.pointsOutlineXAnd },
  { kind: "json", about: messages.bothCurvesWithTheir },
];

/** Points of a saved outline leave the curve by so much of its size. */
const FINE = 1 / 5000;
const MOST_POINTS = 100_000;
/** Of a saved picture, in pixels. */
const LONG_SIDE = 2400;
const LINE_WIDTH = 1.8;

/** Saves the curve as it stands. */
export async function save(kind: Kind): Promise<void> {
  try {
    const blob = kind === "png" ? await picture() : text(kind);
    download(blob, nameOf(curves.peek(), curveTime.peek(), kind));
  } catch (problem) {
    notify({ kind: "error", text: messages.curveFailed(wordsOf(problem)) });
  }
}

function text(kind: Exclude<Kind, "png">): Blob {
  const morph = curveMorph.peek();
  const now = curves.peek();
  if (!morph || !now) throw new Error(messages.thereNoCurve);
  const s = curveTime.peek();
  const [x0, y0, x1, y1] = morph.bounds(s);
  const size = Math.max(x1 - x0, y1 - y0);
  const bent = moved(bend.peek());
  const points = morph.polyline(s, { tolerance: FINE * size, most: MOST_POINTS, bend: bent });
  switch (kind) {
    case "svg": {
      const title =
        s === 0 || sameCurves(now)
          ? now.a.name
          : s === 1
            ? now.b.name
            : messages.fromTo(now.a.name, now.b.name);
      const colour = stageStyle.peek().palette[0] ?? GREY;
      return new Blob([svgOf(points, { title, colour })], { type: "image/svg+xml" });
    }
    case "csv":
      return new Blob([csvOf(points)], { type: "text/csv" });
    case "json": {
      const mapped = { a: rough.curveMaps(now.a.curve), b: rough.curveMaps(now.b.curve) };
      return new Blob([jsonOf({ curves: now, maps: mapped, s, bend: bent, points })], {
        type: "application/json",
      });
    }
  }
}

async function picture(): Promise<Blob> {
  const morph = curveMorph.peek();
  if (!morph) throw new Error(messages.thereNoCurve);
  const size = stageSize.peek();
  const larger = LONG_SIDE / Math.max(size.width, size.height, 1);
  const width = Math.max(1, Math.round(size.width * larger));
  const height = Math.max(1, Math.round(size.height * larger));
  const shown = effectiveView.peek();
  const canvas = stillCurve({
    morph,
    s: curveTime.peek(),
    bend: bend.peek(),
    view: { ...shown, scale: shown.scale * larger },
    width,
    height,
    ...stageStyle.peek(),
    dark: dark.peek(),
    lineWidth: LINE_WIDTH * larger,
    carried: tool.peek() === "morph" ? carriedOn(morph, photographsSeen.peek()) : null,
  });
  return canvas.convertToBlob({ type: "image/png" });
}

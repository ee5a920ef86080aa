import { useCallback, useMemo } from "preact/hooks";
import { type Box, fitFor } from "#document/framing";
import { boxOfPoints } from "#geometry/point-box";
import type { MapRow } from "#wasm/api";
import { copies } from "../maps/iterates";
import type { Point } from "../maps/pieces";
import { pictured, type Sheet, useDrawing } from "./canvas";
import css from "./picture.module.css";

/** What is copied: outlines, or a picture on the square from 0 to 1. */
export type Start = { outlines: readonly (readonly Point[])[] } | { picture: ImageBitmap };

interface IteratesProps {
  maps: readonly MapRow[];
  /** How often all maps have been applied. */
  steps: number;
  start: Start;
  box: Box;
  label: string | null;
}

/** A copy that is smaller than this, in pixels of the page, is drawn as a dot: thin lines in it would fade away. */
const SMALL = 3;
/** How large a dot is at least, and as large as it is made where copies lie far enough from each other. */
const [DOT, WIDE_DOT] = [1.8, 3];
const MARGIN = 0.06;

/** A figure after so many steps: in each all that there is is copied by every map. */
export function Iterates({ maps, steps, start, box, label }: IteratesProps) {
  const all = useMemo(() => copies(maps, steps), [maps, steps]);
  const draw = useCallback(
    (sheet: Sheet) => {
      const { context, width, height, ratio, colours, token } = sheet;
      const { x, y, scale } = fitFor(box, { width, height }, MARGIN);
      const path = "outlines" in start ? pathOf(start.outlines) : null;
      const extent = "outlines" in start ? extentOf(start.outlines) : null;
      for (const { map, first } of all) {
        const [a, b, c, d, e, f] = map;
        const [left, top] = [width / 2 + scale * (e - x), height / 2 - scale * (f - y)];
        context.setTransform(scale * a, -scale * c, scale * b, -scale * d, left, top);
        context.fillStyle = first === null ? token("--ink-2") : (colours[first % colours.length] ?? "");
        if ("picture" in start) {
          // Pictures have their y downwards.
          context.transform(1, 0, 0, -1, 0, 1);
          context.drawImage(start.picture, 0, 0, 1, 1);
        } else if (path && extent) {
          const apart = scale * Math.max(Math.hypot(a, c), Math.hypot(b, d));
          const size = apart * extent.size;
          if (size >= SMALL * ratio) {
            context.fill(path);
            continue;
          }
          const [px, py] = extent.middle;
          const side = Math.max(DOT * ratio, Math.min(WIDE_DOT * ratio, apart / 3), 0.8 * size);
          context.setTransform(1, 0, 0, 1, 0, 0);
          context.fillRect(
            left + scale * (a * px + b * py) - side / 2,
            top - scale * (c * px + d * py) - side / 2,
            side,
            side,
          );
        }
      }
    },
    [all, start, box],
  );
  const { canvas } = useDrawing(draw);
  return <canvas ref={canvas} class={css["figure-picture"]} {...pictured(label)} />;
}

/** The middle of all outlines, and how far they reach across or up. */
function extentOf(outlines: readonly (readonly Point[])[]): { middle: Point; size: number } {
  const box = boxOfPoints(outlines.flat(2)) ?? { x0: 0, y0: 0, x1: 0, y1: 0 };
  return {
    middle: [(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2],
    size: Math.max(box.x1 - box.x0, box.y1 - box.y0),
  };
}

function pathOf(outlines: readonly (readonly Point[])[]): Path2D {
  const path = new Path2D();
  for (const outline of outlines) {
    for (const [i, [x, y]] of outline.entries()) {
      if (i === 0) path.moveTo(x, y);
      else path.lineTo(x, y);
    }
    path.closePath();
  }
  return path;
}

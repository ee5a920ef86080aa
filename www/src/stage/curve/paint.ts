/** Paints a closed curve: softly filled, with an outline in one colour or in those of what its edges copy. */

import type { CurveMorph } from "#document/curve/curve";
import { dark } from "#document/preferences";
import { GREY } from "#style/colours";
import type { Colouring } from "#wasm/api";
import { edgeColours } from "./colours";
import { type Frame, fillPath, outlinePaths, type Placed, place } from "./outline";
import type { CarriedPicture } from "./photographs/carried";

/** How a curve is painted. */
interface CurveLook {
  /** Of the area, and of the outline where nothing else is said. */
  colour: string;
  /** Colours of the outline, and for each vertex that of what goes on from there; null: one colour. */
  outline: { colours: readonly string[]; kinds: ArrayLike<number> } | null;
  /** Width of the outline in device pixels. */
  width: number;
  soft: readonly [middle: number, corner: number];
}

/** How much of its colour the area has in the middle, and at the corners of its box: light falls through the middle. */
const SOFT = { light: [0.08, 0.3], dark: [0.36, 0.1] } as const;

/** The look of the polyline that a morph gave last. */
export function lookOf(
  morph: CurveMorph,
  s: number,
  colouring: Colouring,
  palette: readonly string[],
  width: number,
  night = dark.peek(),
): CurveLook {
  const colour = palette[0] ?? GREY;
  const soft = SOFT[night ? "dark" : "light"];
  const edges = edgeColours(morph.arcs(), s, colouring, palette);
  if (!edges) return { colour, outline: null, width, soft };
  const kinds = Uint16Array.from(morph.edges(), (edge) => edges.kinds[edge] ?? 0);
  return { colour, outline: { colours: edges.colours, kinds }, width, soft };
}

/** Paints vertices x0, y0, x1, y1, .. of the plane. */
export function paintCurve(
  context: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D,
  vertices: Float64Array,
  frame: Frame,
  { colour, outline, width, soft }: CurveLook,
): void {
  context.clearRect(0, 0, frame.width, frame.height);
  const placed = place(vertices, frame);
  const area = new Path2D();
  fillPath(area, placed);
  context.fillStyle = shade(context, placed, colour, soft);
  // Where a morph crosses itself, what is inside once or twice is inside.
  context.fill(area, "nonzero");
  context.lineWidth = width;
  context.lineJoin = "round";
  context.lineCap = "round";
  const kinds = outline?.kinds;
  const paths = outlinePaths(placed, () => new Path2D(), kinds ? (i) => kinds[i] ?? 0 : undefined);
  for (const [kind, path] of paths) {
    context.strokeStyle = outline?.colours[kind] ?? colour;
    context.stroke(path);
  }
}

/** Paints what lies on a box of the plane inside the same curve, without an outline. */
export function paintInside(
  context: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D,
  vertices: Float64Array,
  frame: Frame,
  { canvas, box: [x0, y0, x1, y1] }: CarriedPicture,
): void {
  context.clearRect(0, 0, frame.width, frame.height);
  const area = new Path2D();
  fillPath(area, place(vertices, frame));
  const { points } = place(Float64Array.of(x0, y1, x1, y0), frame);
  const [left = 0, top = 0, right = 0, bottom = 0] = points;
  context.save();
  context.clip(area, "nonzero");
  context.imageSmoothingQuality = "high";
  context.drawImage(canvas, left, top, right - left, bottom - top);
  context.restore();
}

/** Lighter in the middle of the curve: it lies there like a leaf held against the light. */
function shade(
  context: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D,
  { extent: [x0, y0, x1, y1] }: Placed,
  colour: string,
  [middle, corner]: CurveLook["soft"],
): CanvasGradient | string {
  const radius = Math.hypot(x1 - x0, y1 - y0) / 2;
  const alpha = (part: number) =>
    `${colour}${Math.round(255 * part)
      .toString(16)
      .padStart(2, "0")}`;
  if (!(radius > 0 && radius < 1e7)) return alpha(middle);
  const [x, y] = [(x0 + x1) / 2, (y0 + y1) / 2];
  const gradient = context.createRadialGradient(x, y, 0, x, y, radius);
  gradient.addColorStop(0, alpha(middle));
  gradient.addColorStop(1, alpha(corner));
  return gradient;
}

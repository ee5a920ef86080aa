/** Paints a closed curve: softly filled, with an outline in one colour or in those of its copies. */
import type { Colouring } from "../engine/api";
import { type Frame, fillPath, outlinePaths, place } from "./curve";

/** How a curve is painted. */
export interface CurveLook {
  /** Of the area, and of the outline where nothing else is said. */
  colour: string;
  /** By kind of edge; null: the outline has one colour. */
  kinds: readonly string[] | null;
  /** Width of the outline in device pixels. */
  width: number;
}

/** How much of its colour the area has. */
const SOFT = 0.15;

/** The look of the stage, for a theme's palette. */
export function lookOf(colouring: Colouring, palette: readonly string[], width: number): CurveLook {
  const coloured = colouring === "map" || colouring === "address";
  return { colour: palette[0] ?? "#808080", kinds: coloured ? palette : null, width };
}

/** A vertex for every two numbers, the kind of the edge that begins at each, and where to. */
export function paintCurve(
  context: CanvasRenderingContext2D | OffscreenCanvasRenderingContext2D,
  vertices: Float64Array,
  kinds: ArrayLike<number> | null,
  frame: Frame,
  look: CurveLook,
): void {
  context.clearRect(0, 0, frame.width, frame.height);
  const placed = place(vertices, frame);
  const area = new Path2D();
  fillPath(area, placed);
  context.fillStyle = look.colour;
  context.globalAlpha = SOFT;
  // Where a morph crosses itself, what is inside once or twice is inside.
  context.fill(area, "nonzero");
  context.globalAlpha = 1;
  context.lineWidth = look.width;
  context.lineJoin = "round";
  context.lineCap = "round";
  const colours = kinds && look.kinds;
  const kindOf = colours ? (segment: number) => kinds[segment] ?? 0 : () => 0;
  for (const [kind, path] of outlinePaths(placed, () => new Path2D(), kindOf)) {
    context.strokeStyle = colours ? (colours[kind % colours.length] ?? look.colour) : look.colour;
    context.stroke(path);
  }
}

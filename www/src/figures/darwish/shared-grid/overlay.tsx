import { useCallback } from "preact/hooks";
import type { Size } from "#geometry/coordinates";
import { type Sheet, useDrawing } from "../../kit/picture/canvas";
import { useDrag } from "../../kit/picture/drag";
import css from "./overlay.module.css";

export interface Layers {
  /** Where each shape is, as white pixels; null where there is nothing. */
  first: ImageBitmap | null;
  second: ImageBitmap | null;
  shared: ImageBitmap | null;
  /** Points that are marked, on the canvas from 0 to 1. */
  marks: readonly (readonly [x: number, y: number])[];
  /** Whether what they share is so thin that it is drawn thicker. */
  thin: boolean;
}

interface DrawingProps {
  layers: Layers;
  /** What is shown of it. */
  shown: { first: boolean; second: boolean };
  /** Drawn as bands: the first on top, the second below, what they share through both. */
  isLine: boolean;
}

interface OverlayProps extends DrawingProps {
  label: string;
  /** The hand has moved by so many pixels of the page, to the right and upwards. */
  onDrag: (dx: number, dy: number) => void;
  /** A key asks for so many steps. */
  onStep: (dx: number, dy: number) => void;
}

/** Places in the palette. */
export const COLOURS = { first: 1, second: 0 } as const;

/** From top to bottom, as parts of the height. */
const BANDS = { first: [0.1, 0.46], second: [0.54, 0.9], shared: [0.1, 0.9] } as const;
const WHOLE = [0, 1] as const;
const KEYS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Two shapes over each other, and what they share. */
export function Drawing({ layers, shown, isLine }: DrawingProps) {
  const draw = useCallback(
    (sheet: Sheet) => {
      const { context, colours, token } = sheet;
      const ink = token("--ink");
      context.imageSmoothingEnabled = !isLine;
      const { width, height } = sheet;
      const paint = (
        bitmap: ImageBitmap | null,
        colour: string,
        [from, to]: readonly [number, number],
        places: readonly (readonly [number, number])[] = [[0, 0]],
      ) => {
        if (!bitmap) return;
        const picture = tinted(bitmap, colour);
        for (const [dx, dy] of places) {
          context.drawImage(picture, dx, dy + from * height, width, (to - from) * height);
        }
      };
      const bands = isLine ? BANDS : { first: WHOLE, second: WHOLE, shared: WHOLE };
      context.globalAlpha = isLine ? 1 : 0.8;
      if (shown.first) paint(layers.first, colours[COLOURS.first] ?? ink, bands.first);
      if (shown.second) paint(layers.second, colours[COLOURS.second] ?? ink, bands.second);
      context.globalAlpha = 1;
      paint(layers.shared, ink, bands.shared, layers.thin ? around(sheet.ratio, isLine) : undefined);
      mark(sheet, layers.marks, ink);
    },
    [layers, shown, isLine],
  );
  const { canvas } = useDrawing(draw);
  return <canvas ref={canvas} />;
}

/** The same to be moved: the second is dragged, and follows the arrow keys. */
export function Overlay({ label, onDrag, onStep, ...drawing }: OverlayProps) {
  const drag = useDrag((dx, dy) => onDrag(dx, -dy));
  return (
    <div
      class={`${css["overlay"]} ${drawing.isLine ? css["line"] : ""}`}
      role="application"
      aria-label={`${label} Arrow keys move the second shape.`}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: arrow keys move what is in it
      tabIndex={0}
      {...drag}
      onKeyDown={(event) => {
        const step = KEYS[event.key];
        if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
        event.preventDefault();
        const far = event.shiftKey ? 10 : 1;
        onStep(far * step[0], far * step[1]);
      }}
    >
      <Drawing {...drawing} />
    </div>
  );
}

/** The size that pictures have to have. */
export function bitmapSize({ width, height }: Size, isLine: boolean): Size {
  // Of a line one row is enough: it is stretched.
  return { width, height: isLine ? 1 : height };
}

/** The same in one colour. */
function tinted(bitmap: ImageBitmap, colour: string): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = bitmap.width;
  canvas.height = bitmap.height;
  const context = canvas.getContext("2d");
  if (context) {
    context.drawImage(bitmap, 0, 0);
    context.globalCompositeOperation = "source-in";
    context.fillStyle = colour;
    context.fillRect(0, 0, canvas.width, canvas.height);
  }
  return canvas;
}

/** Places around a pixel, so near that a point grows to a dot. */
function around(ratio: number, isLine: boolean): readonly (readonly [number, number])[] {
  const reach = [-0.5, 0, 0.5];
  return reach.flatMap((dx) =>
    isLine ? [[dx * ratio, 0] as const] : reach.map((dy) => [dx * ratio, dy * ratio] as const),
  );
}

/** Rings around single points, which are too small to be seen. */
function mark({ context, width, height, ratio }: Sheet, marks: Layers["marks"], ink: string) {
  context.strokeStyle = ink;
  context.lineWidth = 1.5 * ratio;
  for (const [x, y] of marks) {
    context.beginPath();
    context.arc(x * width, y * height, 6 * ratio, 0, 2 * Math.PI);
    context.stroke();
  }
}

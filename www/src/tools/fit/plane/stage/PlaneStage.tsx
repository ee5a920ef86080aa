import { useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { type Screen, type Size, toScreen, type View, world } from "#geometry/coordinates";
import { palette } from "#style/palette";
import { attachPanZoom, type PanZoom, panZoomKey } from "#ui/panZoom";
import { emptied, useBox, ZoomButtons } from "../../by-hand/canvas";
import css from "../../graph/graph.module.css";
import * as messages from "../../messages";
import type { PlaneCurve } from "../model/curve";
import { chosenPiece, curve, damage, problem } from "../model/document";
import { Points } from "./Points";
import { drawn, magnified, panBy, showAll, stageBox, view, zoomAbout } from "./shown";

/** So near to a piece a press chooses it, in pixels. */
const NEAR = 16;

const PICTURE: PanZoom = { pan: panBy, zoom: zoomAbout, fit: showAll, tap: choosePiece };

/** A press on the curve chooses the piece. */
function choosePiece({ x, y }: Screen): void {
  const { line } = drawn.peek();
  const [now, size] = [view.peek(), stageBox.peek()];
  let [nearest, t] = [NEAR, Number.NaN];
  for (let i = 0; i + 2 < line.length; i += 3) {
    const at = toScreen(world(line[i + 1] ?? 0, line[i + 2] ?? 0), now, size);
    const off = Math.hypot(at.x - x, at.y - y);
    if (off < nearest) [nearest, t] = [off, line[i] ?? 0];
  }
  const index = curve.peek().points.findLastIndex((point) => point[0] <= t);
  if (index >= 0) chosenPiece.value = Math.min(index, curve.peek().pieces.length - 1);
}

/** The curve and its points, which hands move. */
export function PlaneStage() {
  const root = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => (root.current ? attachPanZoom(root.current, PICTURE) : undefined), []);
  useBox(root, stageBox);
  useSignalEffect(() => {
    const element = canvas.current;
    const size = stageBox.value;
    const context = emptied(element, size);
    if (!element || !context) return;
    sides(
      context,
      curve.value,
      view.value,
      size,
      getComputedStyle(element).getPropertyValue("--line-strong"),
    );
    const colours = palette(dark.value ? "dark" : "light");
    trace(context, curve.value, drawn.value.line, view.value, size, colours, chosenPiece.value);
  });
  return (
    <div
      ref={root}
      class={css["graph-stage"]}
      data-points={drawn.value.line.length / 3}
      role="application"
      aria-label={messages.curveArrowKeysMove}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: it takes keys
      tabIndex={0}
      onKeyDown={(event) => {
        if (event.target === event.currentTarget && panZoomKey(event, PICTURE)) event.preventDefault();
      }}
    >
      <canvas ref={canvas} />
      <Points />
      <Foot />
    </div>
  );
}

/** The straight sides from point to point, under the curve. */
function sides(
  context: CanvasRenderingContext2D,
  { points }: PlaneCurve,
  now: View,
  size: Size,
  colour: string,
): void {
  context.strokeStyle = colour;
  context.lineWidth = 1;
  context.setLineDash([3, 4]);
  context.beginPath();
  for (const [, x, y] of points) {
    const at = toScreen(world(x, y), now, size);
    context.lineTo(at.x, at.y);
  }
  context.stroke();
  context.setLineDash([]);
}

/** The curve, each piece in its colour, the chosen one thicker. */
function trace(
  context: CanvasRenderingContext2D,
  { points }: PlaneCurve,
  line: Float64Array,
  now: View,
  size: Size,
  colours: readonly string[],
  chosen: number,
): void {
  context.lineJoin = "round";
  let i = 0;
  for (let piece = 0; piece + 1 < points.length; piece++) {
    const end = points[piece + 1]?.[0] ?? 1;
    context.strokeStyle = colours[piece % colours.length] ?? "gray";
    context.lineWidth = piece === chosen ? 2.25 : 1.5;
    context.beginPath();
    let pen = false;
    for (; i + 2 < line.length; i += 3) {
      const [t, x, y] = [line[i] ?? 0, line[i + 1] ?? 0, line[i + 2] ?? 0];
      if (Number.isNaN(x)) {
        pen = false;
      } else {
        const left = size.width / 2 + (x - now.x) * now.scale;
        const top = size.height / 2 - (y - now.y) * now.scale;
        if (pen) context.lineTo(left, top);
        else context.moveTo(left, top);
        pen = true;
      }
      // The first point of the next piece is the last of this one.
      if (t >= end && piece + 2 < points.length) break;
    }
    context.stroke();
  }
}

function Foot() {
  const wrong = problem.value;
  const { complete, line } = drawn.value;
  return (
    <div class={css["graph-foot"]} data-handle="">
      {wrong !== null && (
        <p class={css["graph-problem"]} role="alert">
          {messages.lastStays(wrong)}
        </p>
      )}
      {damage.value !== null && (
        <p class={css["graph-problem"]} role="alert">
          {damage.value}
        </p>
      )}
      {!complete && (
        <p class="readout" data-part="coarse">
          {messages.drawnWith((line.length / 3).toLocaleString("en-GB"))}
        </p>
      )}
      <ZoomButtons zoom={magnified.value} zoomAbout={zoomAbout} showAll={showAll} />
    </div>
  );
}

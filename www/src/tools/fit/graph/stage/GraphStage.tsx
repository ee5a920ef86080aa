import { useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { emptied, useBox, ZoomButtons } from "../../by-hand/canvas";
import graphCss from "../graph.module.css";
import * as messages from "../messages";
import { chosenPiece, graph, problem } from "../model/document";
import { offWords } from "../model/graph-text";
import { rangeOf } from "../model/model";
import { reading, series, unmade } from "../model/series";
import { tAt } from "./frame";
import { Knots } from "./Knots";
import { BAND, paint } from "./paint";
import {
  attachGestures,
  copyShown,
  errors,
  frame,
  magnified,
  polyline,
  showAll,
  stageBox,
  stageKey,
  zoomAbout,
} from "./view";

/** The graph, what is measured, and the points that hands move. */
export function GraphStage() {
  const root = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => (root.current ? attachGestures(root.current, choosePiece) : undefined), []);
  useBox(root, stageBox);
  useSignalEffect(() => {
    const element = canvas.current;
    const context = emptied(element, stageBox.value);
    if (!element || !context) return;
    const colours = palette(dark.value ? "dark" : "light");
    const style = getComputedStyle(element);
    const colour = (name: string) => style.getPropertyValue(name).trim();
    paint(
      context,
      frame.value,
      {
        pieces: unmade.value ? [] : graph.value.pieces,
        polyline: polyline.value,
        faint: copyShown.value !== null,
        series: series.value?.points ?? null,
        copy: copyShown.value,
        worst: errors.value && errors.value.worst > 0 ? errors.value.where : null,
        chosenPiece: chosenPiece.value,
      },
      {
        palette: colours,
        ink: colour("--ink"),
        quiet: colour("--ink-2"),
        line: colour("--line"),
        ground: colour("--stage"),
        accent: colour("--accent"),
      },
    );
  });
  return (
    <div
      ref={root}
      class={graphCss["graph-stage"]}
      data-points={polyline.value.length / 2}
      role="application"
      aria-label={messages.graphLeftAndRight}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: it takes keys
      tabIndex={0}
      onKeyDown={(event) => {
        if (event.target === event.currentTarget && stageKey(event)) event.preventDefault();
      }}
    >
      <canvas ref={canvas} />
      {!unmade.value && <Knots faint={copyShown.value !== null} />}
      <Foot />
    </div>
  );
}

/** A press on the band below the graph chooses the piece. */
function choosePiece(left: number, top: number): void {
  const view = frame.peek();
  const below = top - view.top - view.height - BAND.below;
  if (below < -4 || below > BAND.height + 8) return;
  const t = tAt(view, left);
  const index = graph.peek().pieces.findIndex((piece) => {
    const [from, to] = rangeOf(piece);
    return t >= from && t <= to;
  });
  if (index >= 0) chosenPiece.value = index;
}

function Foot() {
  const off = errors.value;
  const words = off && offWords(off).replace("off", messages.off);
  const wrong = problem.value;
  return (
    <div class={graphCss["graph-foot"]} data-handle="">
      {wrong !== null && (
        <p class={graphCss["graph-problem"]} role="alert">
          {wrong}
        </p>
      )}
      {reading.value !== null && <p class="readout">{messages.readingOf(reading.value)}</p>}
      {words && (
        <p class="readout" data-part="errors">
          {words}
        </p>
      )}
      <ZoomButtons zoom={magnified.value} zoomAbout={zoomAbout} showAll={showAll} />
    </div>
  );
}

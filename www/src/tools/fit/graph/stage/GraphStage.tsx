import { useSignalEffect } from "@preact/signals";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { formatNumber } from "#format/numbers";
import { palette } from "#style/palette";
import { IconButton } from "#ui/controls/Button";
import graphCss from "../graph.module.css";
import { chosenPiece, graph, problem } from "../model/document";
import { errors } from "../model/errors";
import { rangeOf } from "../model/model";
import { reading, series, unmade } from "../model/series";
import { magnified, showAll, zoomAbout } from "../model/span";
import { offWords } from "../model/words";
import { copyShown } from "./copy";
import { tAt } from "./frame";
import { attachGestures, stageKey } from "./gestures";
import { Knots } from "./Knots";
import { BAND, paint } from "./paint";
import { frame, polyline, stageBox } from "./shown";

/** The graph, what is measured, and the points that hands move. */
export function GraphStage() {
  const root = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => (root.current ? attachGestures(root.current, choosePiece) : undefined), []);
  useLayoutEffect(() => {
    const element = root.current;
    if (!element) return;
    const measure = () => {
      stageBox.value = { width: element.clientWidth, height: element.clientHeight };
    };
    const watch = new ResizeObserver(measure);
    watch.observe(element);
    measure();
    return () => watch.disconnect();
  }, []);
  useSignalEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    const { width, height } = stageBox.value;
    if (!element || !context || width === 0) return;
    const ratio = Math.min(3, globalThis.devicePixelRatio || 1);
    const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (element.width !== across) element.width = across;
    if (element.height !== down) element.height = down;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
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
      aria-label="The graph. Left and right arrows move it, plus and minus zoom, 0 shows all of it."
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
  const words = off && offWords(off).replace("off", "Off");
  const wrong = problem.value;
  const zoom = magnified.value;
  return (
    <div class={graphCss["graph-foot"]} data-handle="">
      {wrong !== null && (
        <p class={graphCss["graph-problem"]} role="alert">
          {wrong}
        </p>
      )}
      {reading.value !== null && <p class="readout">Reading {reading.value} …</p>}
      {words && (
        <p class="readout" data-part="errors">
          {words}
        </p>
      )}
      <div class={graphCss["graph-zoom"]}>
        {zoom > 1.01 && <span class="readout number">{formatNumber(zoom, zoom < 10 ? 1 : 0)}×</span>}
        <IconButton kind="quiet" icon="remove" label="Zoom out" onClick={() => zoomAbout(1 / 1.6)} />
        <IconButton kind="quiet" icon="add" label="Zoom in" onClick={() => zoomAbout(1.6)} />
        <IconButton
          kind="quiet"
          icon="whole"
          label="Show all of it"
          disabled={Math.abs(zoom - 1) < 1e-6}
          onClick={showAll}
        />
      </div>
    </div>
  );
}

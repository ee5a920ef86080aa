import { effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { curveTime, knotted, stageMorph } from "#document/curve/curve";
import { drawnEnds } from "#document/curve/drawn";
import { photographsSeen, watchPhotographs } from "#document/curve/photographs";
import { bend, bendProblem } from "#document/deform/bend";
import { tool } from "#document/tool";
import { attachGestures } from "../gestures";
import { watchSize } from "../picture";
import { stageStyle } from "../picture-style";
import type { MainPainter, PainterState } from "../surface/painter";
import { effectiveView, stageSize } from "../view";
import { watchFilm } from "./film";
import { CurvePainter } from "./painter";

knotted.value = drawnEnds;

interface CurvePictureProps {
  onState: (state: PainterState) => void;
  onPainter: (painter: MainPainter | null) => void;
}

/** One canvas that shows the closed curve at the present moment, sized to its place down to the device pixel. */
export function CurvePicture({ onState, onPainter }: CurvePictureProps) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const painter = new CurvePainter(element, onState, (problem) => {
      bendProblem.value = problem;
    });
    onPainter(painter);
    const device = signal({ width: 0, height: 0, ratio: 1 });
    const stopSize = watchSize(element, (css, exact) => {
      // Where the screen is only pretended, what the browser calls device pixels are those of the page.
      const ratio = globalThis.devicePixelRatio || 1;
      const sharp = { width: Math.round(css.width * ratio), height: Math.round(css.height * ratio), ratio };
      device.value = exact.ratio < 0.75 * ratio && exact.ratio === 1 ? sharp : exact;
      stageSize.value = css;
    });
    const stopShow = effect(() => {
      const size = device.value;
      painter.show({
        ...size,
        morph: stageMorph.value,
        s: curveTime.value,
        bend: bend.value,
        view: effectiveView.value,
        style: stageStyle.value,
        photographs: tool.value === "morph" ? photographsSeen.value : null,
      });
    });
    const stopGestures = attachGestures(element);
    const stopFilm = watchFilm();
    const stopPhotographs = watchPhotographs();
    return () => {
      stopPhotographs();
      stopFilm();
      stopGestures();
      stopShow();
      stopSize();
      onPainter(null);
      painter.close();
    };
  }, [onState, onPainter]);
  return <div ref={host} class="picture" />;
}

import { effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { directedMoment } from "#document/directed/directed";
import { directedBoxAt } from "#document/stand-in";
import { attachGestures } from "../gestures";
import { watchSize } from "../picture";
import { stageStyle } from "../picture-style";
import type { MainPainter, PainterState } from "../surface/painter";
import { effectiveView, stageSize } from "../view";
import { watchFilm } from "./film";
import { directedProblem, watchKnown } from "./known";
import { DirectedPainter } from "./painter";

interface DirectedPictureProps {
  onState: (state: PainterState) => void;
  onPainter: (painter: MainPainter | null) => void;
}

/** One canvas that shows the graph-directed shape at the present moment, sized to its place in device pixels. */
export function DirectedPicture({ onState, onPainter }: DirectedPictureProps) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const painter = new DirectedPainter(element, onState, (problem) => {
      directedProblem.value = problem;
    });
    onPainter(painter);
    const device = signal({ width: 0, height: 0, ratio: 1 });
    const stopSize = watchSize(element, (css, exact) => {
      device.value = exact;
      stageSize.value = css;
    });
    const stopShow = effect(() => {
      const size = device.value;
      const moment = directedMoment.value;
      // Until it is known where the shape lies, what was there before is where it would be looked for: a dot at best.
      if (!moment || !directedBoxAt.value || size.width === 0 || size.height === 0) return;
      painter.show({ ...size, moment, view: effectiveView.value, style: stageStyle.value });
    });
    const stops = [stopShow, stopSize, attachGestures(element), watchFilm(), watchKnown()];
    return () => {
      for (const stop of stops) stop();
      onPainter(null);
      painter.close();
    };
  }, [onState, onPainter]);
  return <div ref={host} class="picture" />;
}

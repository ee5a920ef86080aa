/** The picture of an attractor on the stage. */
import { effect, type ReadonlySignal, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { bendProblem } from "#document/deform/bend";
import type { Photograph } from "#document/deform/photograph";
import type { Bend, MapRow } from "#wasm/api";
import { attachGestures } from "./gestures";
import { stageStyle } from "./picture-style";
import { Painter, type PainterBackend, type PainterState } from "./surface/painter";
import { effectiveView, stageSize } from "./view";

interface PictureProps {
  maps: ReadonlySignal<MapRow[]>;
  weights?: ReadonlySignal<number[] | undefined>;
  bend: ReadonlySignal<Bend | null>;
  /** What takes the place of the attractor. */
  photograph?: ReadonlySignal<Photograph | null>;
  backend: "auto" | PainterBackend;
  /** The one that the readouts, the export and the tests speak of; else it stands beside it to compare. */
  main?: boolean;
  onState: (state: PainterState) => void;
  onPainter?: (painter: Painter | null) => void;
}

const MOST_PIXELS = 8192;

/** One canvas that shows one attractor, sized to its place down to the device pixel. */
export function Picture({
  maps,
  weights,
  bend,
  photograph,
  backend,
  main = false,
  onState,
  onPainter,
}: PictureProps) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const painter = new Painter(element, {
      backend,
      onState,
      onBendProblem: (problem) => {
        if (main) bendProblem.value = problem;
      },
    });
    onPainter?.(painter);
    const device = signal({ width: 0, height: 0, ratio: 1 });
    const stopSize = watchSize(element, (css, pixels) => {
      device.value = pixels;
      if (main) stageSize.value = css;
    });
    const stopShow = effect(() => {
      const size = device.value;
      if (size.width === 0 || size.height === 0) return;
      painter.show({
        ...size,
        maps: maps.value,
        weights: weights?.value,
        bend: bend.value,
        picture: photograph?.value ?? null,
        view: effectiveView.value,
        style: stageStyle.value,
      });
    });
    const stopGestures = attachGestures(element);
    return () => {
      stopGestures();
      stopShow();
      stopSize();
      onPainter?.(null);
      painter.close();
    };
  }, [maps, weights, bend, photograph, backend, main, onState, onPainter]);
  return <div ref={host} class="picture" />;
}

interface Extent {
  width: number;
  height: number;
}

/** Reports the size in CSS pixels and, exactly where the browser knows it, in device pixels, and how many make one. */
export function watchSize(
  element: HTMLElement,
  report: (css: Extent, device: Extent & { ratio: number }) => void,
): () => void {
  const observer = new ResizeObserver((entries) => {
    const entry = entries.at(-1);
    if (!entry) return;
    const css = { width: entry.contentRect.width, height: entry.contentRect.height };
    const exact = entry.devicePixelContentBoxSize?.[0];
    const ratio = globalThis.devicePixelRatio || 1;
    const device = exact
      ? { width: exact.inlineSize, height: exact.blockSize }
      : { width: Math.round(css.width * ratio), height: Math.round(css.height * ratio) };
    const scale = Math.min(1, MOST_PIXELS / Math.max(device.width, device.height, 1));
    const width = Math.floor(device.width * scale);
    const height = Math.floor(device.height * scale);
    report(css, { width, height, ratio: css.width > 0 ? width / css.width : 1 });
  });
  try {
    observer.observe(element, { box: "device-pixel-content-box" });
  } catch {
    observer.observe(element);
  }
  return () => observer.disconnect();
}

/** A canvas that fills its place, in CSS pixels. */

import type { Signal } from "@preact/signals";
import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";
import { formatNumber } from "#format/numbers";
import type { Size } from "#geometry/coordinates";
import { IconButton } from "#ui/controls/Button";
import css from "../graph/graph.module.css";
import * as messages from "../messages";

/** Keeps the size of an element in `box`. */
export function useBox(root: RefObject<HTMLElement | null>, box: Signal<Size>): void {
  useLayoutEffect(() => {
    const element = root.current;
    if (!element) return;
    const measure = () => {
      box.value = { width: element.clientWidth, height: element.clientHeight };
    };
    const watch = new ResizeObserver(measure);
    watch.observe(element);
    measure();
    return () => watch.disconnect();
  }, [root, box]);
}

/** An empty canvas of that size, as fine as the screen; null where there is nothing to draw on. */
export function emptied(canvas: HTMLCanvasElement | null, { width, height }: Size) {
  const context = canvas?.getContext("2d");
  if (!canvas || !context || width === 0) return null;
  const ratio = Math.min(3, globalThis.devicePixelRatio || 1);
  const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== across) canvas.width = across;
  if (canvas.height !== down) canvas.height = down;
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}

interface ZoomButtonsProps {
  /** How many times larger than the whole it is shown. */
  zoom: number;
  zoomAbout: (factor: number) => void;
  showAll: () => void;
}

/** How near one is, and the ways nearer, farther, and back to the whole. */
export function ZoomButtons({ zoom, zoomAbout, showAll }: ZoomButtonsProps) {
  return (
    <div class={css["graph-zoom"]}>
      {zoom > 1.01 && <span class="readout number">{formatNumber(zoom, zoom < 10 ? 1 : 0)}×</span>}
      <IconButton kind="quiet" icon="remove" label={messages.zoomOut} onClick={() => zoomAbout(1 / 1.6)} />
      <IconButton kind="quiet" icon="add" label={messages.zoomIn} onClick={() => zoomAbout(1.6)} />
      <IconButton
        kind="quiet"
        icon="whole"
        label={messages.resetView}
        disabled={Math.abs(zoom - 1) < 1e-6}
        onClick={showAll}
      />
    </div>
  );
}

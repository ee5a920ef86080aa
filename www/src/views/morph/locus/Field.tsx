import { useLayoutEffect, useRef } from "preact/hooks";
import type { Bounds } from "../../../engine/api";
import type { WindowResult } from "../../../engine/results";
import type { Family } from "../../../engine/window";
import { type LocusStyle, paint } from "./paint";

const MOST_PIXELS = 1024;

export interface FieldProps {
  found: WindowResult | null;
  /** What the square shows, of which plane, how near. */
  frame: Bounds;
  family: Family;
  zoom: number;
  style: LocusStyle;
}

/**
 * Painted in device pixels, so that the patterns are crisp. What is known of the window is read anew for every picture,
 * coarser samples standing in for those that are not there yet: moving about never leaves it blank.
 */
export function Field({ found, frame, family, zoom, style }: FieldProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context) return;
    const scale = Math.min(2, globalThis.devicePixelRatio || 1);
    const size = Math.max(64, Math.min(MOST_PIXELS, Math.round(element.clientWidth * scale)));
    if (element.width !== size) {
      element.width = size;
      element.height = size;
    }
    if (found?.pyramid.family !== family) {
      context.clearRect(0, 0, size, size);
      return;
    }
    const field = found.pyramid.read(frame, zoom);
    const pixels = paint(field, size, { style, scale, epsilon: field.epsilon, window: frame });
    context.putImageData(new ImageData(pixels, size, size), 0, 0);
  }, [found, style, frame, family, zoom]);
  return <canvas ref={canvas} class="locus-field" width={256} height={256} />;
}

import "#style/locus.css";
import "./locus.css";
import { useLayoutEffect, useRef, useState } from "preact/hooks";
import type { Field as Samples } from "#compute/locus/pyramid";
import type { Bounds } from "#wasm/api";
import { type LocusStyle, paint } from "./paint";

const MOST_PIXELS = 2048;

export interface FieldProps {
  samples: Samples | null;
  /** What the square shows. */
  frame: Bounds;
  style: LocusStyle;
}

/** Painted in device pixels, so that the patterns are crisp. */
export function Field({ samples, frame, style }: FieldProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [width, setWidth] = useState(0);
  useLayoutEffect(() => {
    const element = canvas.current;
    if (!element) return;
    const observer = new ResizeObserver(() => setWidth(element.clientWidth));
    observer.observe(element);
    return () => observer.disconnect();
  }, []);
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context) return;
    const scale = Math.min(2, globalThis.devicePixelRatio || 1);
    const size = Math.max(64, Math.min(MOST_PIXELS, Math.round((width || element.clientWidth) * scale)));
    if (element.width !== size) {
      element.width = size;
      element.height = size;
    }
    if (samples === null) {
      context.clearRect(0, 0, size, size);
      return;
    }
    const pixels = paint(samples, size, { style, scale, epsilon: samples.epsilon, window: frame });
    context.putImageData(new ImageData(pixels, size, size), 0, 0);
  }, [samples, frame, style, width]);
  return <canvas ref={canvas} class="locus-field" width={256} height={256} />;
}

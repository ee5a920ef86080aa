import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef, useState } from "preact/hooks";
import { dark } from "#document/preferences";
import type { Size } from "#geometry/coordinates";
import { palette } from "#style/palette";
import { useValue } from "../workers";

const MOST_RATIO = 2;

/** Device pixels that a pixel of the page is drawn with. */
export const pixelRatio = () => Math.min(MOST_RATIO, globalThis.devicePixelRatio || 1);

/** The size of an element in device pixels, or null while it has none. */
export function usePixels(ref: { current: Element | null }): Size | null {
  const [size, setSize] = useState<Size | null>(null);
  useEffect(() => {
    const element = ref.current;
    if (!element) return;
    const observer = new ResizeObserver((entries) => {
      const box = entries.at(-1)?.contentRect;
      if (!box || box.width < 1 || box.height < 1) return;
      const next = {
        width: Math.round(box.width * pixelRatio()),
        height: Math.round(box.height * pixelRatio()),
      };
      setSize((now) => (now?.width === next.width && now.height === next.height ? now : next));
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [ref]);
  return size;
}

/** The width of an element in pixels of the page, 0 while it has none. */
export function useWidth(ref: { current: Element | null }): number {
  return (usePixels(ref)?.width ?? 0) / pixelRatio();
}

/** What a picture is to those who hear it; null for one that its surroundings describe. */
export function pictured(label: string | null) {
  return label === null ? { "aria-hidden": "true" as const } : { role: "img" as const, "aria-label": label };
}

/** What is drawn on. */
export interface Sheet extends Size {
  context: CanvasRenderingContext2D;
  /** Device pixels for a pixel of the page. */
  ratio: number;
  /** The palette. */
  colours: readonly string[];
  /** The value of a custom property, such as `--ink`. */
  token: (name: string) => string;
}

/** A canvas that is drawn anew when `draw` is another function, and when its size or the colours of the page change. */
export function useDrawing(draw: (sheet: Sheet) => void): {
  canvas: RefObject<HTMLCanvasElement | null>;
  pixels: Size | null;
} {
  const canvas = useRef<HTMLCanvasElement>(null);
  const pixels = usePixels(canvas);
  const onDark = useValue(dark);
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context || !pixels) return;
    element.width = pixels.width;
    element.height = pixels.height;
    const style = getComputedStyle(element);
    const token = (name: string) => style.getPropertyValue(name).trim();
    draw({ ...pixels, context, ratio: pixelRatio(), colours: palette(onDark ? "dark" : "light"), token });
  }, [draw, pixels, onDark]);
  return { canvas, pixels };
}

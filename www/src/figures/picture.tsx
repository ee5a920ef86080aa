import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import type { MapRow } from "../engine/api";
import type { Task } from "../engine/protocol";
import { type Box, fitFor } from "../state/fit";
import { dark } from "../state/preferences";
import { palette } from "../style/palette";
import { useAsk, useValue } from "./work";

export interface PictureProps {
  maps: MapRow[];
  /** What part of the plane is shown. Several pictures with the same box can be compared. */
  box: Box;
  /** What is seen, in words; null for a picture that its surroundings describe. */
  label: string | null;
  margin?: number;
  priority?: number;
}

const MOST_RATIO = 2;

/** An attractor, drawn by a worker, as large as its place. */
export function Picture({ maps, box, label, margin = 0.05, priority = 44 }: PictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const size = usePixels(canvas);
  const onDark = useValue(dark);
  const task = useMemo<Task<"picture"> | null>(() => {
    if (size === null) return null;
    const view = fitFor(box, size, margin);
    const colours = palette(onDark ? "dark" : "light");
    return { kind: "picture", maps, options: { ...size, view, colouring: "map", palette: colours } };
  }, [maps, box, size, margin, onDark]);
  useAsk<"picture">(task, priority, {
    accept(_, bitmap) {
      if (canvas.current) paint(canvas.current, bitmap);
      bitmap.close();
    },
    // Without an attractor there is nothing to see, and the verdict beside it says so.
    fail() {
      if (canvas.current) canvas.current.width += 0;
    },
  });
  return (
    <canvas
      ref={canvas}
      class="figure-picture"
      {...(label === null ? { "aria-hidden": "true" } : { role: "img", "aria-label": label })}
    />
  );
}

function paint(canvas: HTMLCanvasElement, bitmap: ImageBitmap): void {
  canvas.width = bitmap.width;
  canvas.height = bitmap.height;
  canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
}

/** The size of an element in device pixels, or null while it has none. */
export function usePixels(ref: { current: Element | null }): { width: number; height: number } | null {
  const [size, setSize] = useState<{ width: number; height: number } | null>(null);
  useEffect(() => {
    const element = ref.current;
    if (!element) return;
    const observer = new ResizeObserver((entries) => {
      const box = entries.at(-1)?.contentRect;
      if (!box || box.width < 1 || box.height < 1) return;
      const ratio = Math.min(MOST_RATIO, globalThis.devicePixelRatio || 1);
      const next = { width: Math.round(box.width * ratio), height: Math.round(box.height * ratio) };
      setSize((now) => (now?.width === next.width && now.height === next.height ? now : next));
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, [ref]);
  return size;
}

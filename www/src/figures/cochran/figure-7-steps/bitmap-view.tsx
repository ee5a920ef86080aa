import { useLayoutEffect, useRef } from "preact/hooks";
import { pictured } from "../../kit/picture/canvas";
import type { Bitmap } from "./boundary";
import css from "./page.module.css";
import { imageOf } from "./traced-leaf";

/** A bitmap, pixel by pixel. */
export function BitmapView({ bitmap, label }: { bitmap: Bitmap | null; label: string }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    if (!element || !bitmap) return;
    element.width = bitmap.width;
    element.height = bitmap.height;
    element.getContext("2d")?.putImageData(imageOf(bitmap), 0, 0);
  }, [bitmap]);
  return (
    <canvas ref={canvas} class={css["bitmap"]} data-complete={bitmap ? "" : undefined} {...pictured(label)} />
  );
}

import { useLayoutEffect, useRef } from "preact/hooks";
import css from "./film.module.css";

export interface PictureProps {
  image: ImageData | ImageBitmap | null;
  label: string;
  /** Width over height: its place is there before it is. */
  ratio: number;
}

/** A frame, small. */
export function Picture({ image, label, ratio }: PictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    if (!element || !image) return;
    element.width = image.width;
    element.height = image.height;
    const context = element.getContext("2d");
    if (image instanceof ImageData) context?.putImageData(image, 0, 0);
    else context?.drawImage(image, 0, 0);
  }, [image]);
  return (
    <canvas
      ref={canvas}
      class={css["export-picture"]}
      role="img"
      aria-label={label}
      style={{ aspectRatio: String(ratio), "--ratio": String(ratio) }}
    />
  );
}

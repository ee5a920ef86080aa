import "./thumbnail.css";
import { useLayoutEffect, useRef } from "preact/hooks";

/** A picture made by the program. Whatever holds it says what it shows. */
export function Thumbnail({ bitmap }: { bitmap: ImageBitmap | null | undefined }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    // A bitmap that was closed has no size, and one of a worker that died never comes.
    if (element === null || bitmap?.width === 0) return;
    if (!bitmap) {
      // What was drawn before is of something else.
      element.width = 4;
      element.height = 3;
      return;
    }
    element.width = bitmap.width;
    element.height = bitmap.height;
    element.getContext("2d")?.drawImage(bitmap, 0, 0);
  }, [bitmap]);
  return <canvas ref={canvas} class={`thumbnail ${bitmap ? "" : "empty"}`} width={4} height={3} />;
}

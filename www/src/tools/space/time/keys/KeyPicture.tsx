import { useLayoutEffect, useRef } from "preact/hooks";
import timeCss from "../time.module.css";
import { keyPictures } from "./pictures";

/** What is seen at a key, small. */
export function KeyPicture({ index }: { index: number }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const image = keyPictures.value[index] ?? null;
  useLayoutEffect(() => {
    const element = canvas.current;
    if (!element) return;
    element.width = image?.width ?? 1;
    element.height = image?.height ?? 1;
    if (image) element.getContext("2d")?.putImageData(image, 0, 0);
  }, [image]);
  return (
    <span class={timeCss["key-picture"]} aria-hidden="true">
      <canvas ref={canvas} />
    </span>
  );
}

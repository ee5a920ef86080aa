import { useLayoutEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { pictured } from "../../kit/picture/canvas";
import { useValue } from "../../kit/workers";
import css from "./vote-plane.module.css";

/** Bins of a and of c. */
export const BINS = 128;

interface VotePlaneProps {
  /** Hits at a * 128 + c; null before anything is counted. */
  plane: Uint32Array | null;
  label: string | null;
}

/** Hits over a, from left to right, and c, upwards: the darker the more, by the logarithm. */
export function VotePlane({ plane, label }: VotePlaneProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const onDark = useValue(dark);
  useLayoutEffect(() => {
    const context = canvas.current?.getContext("2d");
    if (!canvas.current || !context) return;
    canvas.current.width = BINS;
    canvas.current.height = BINS;
    if (plane) context.putImageData(new ImageData(planePixels(plane, onDark), BINS, BINS), 0, 0);
  }, [plane, onDark]);
  return (
    <div class={css["vote-plane"]}>
      <canvas ref={canvas} {...pictured(label)} />
      <div class={css["vote-axes"]} aria-hidden="true">
        <span class={`${css["c"]} ${css["high"]}`}>c = 1</span>
        <span class={`${css["c"]} ${css["low"]}`}>−1</span>
        <span class={`${css["a"]} ${css["low"]}`}>a = −1</span>
        <span class={`${css["a"]} ${css["high"]}`}>1</span>
      </div>
    </div>
  );
}

/** One colour, the more opaque the more hits; row 0 on top is the largest c. */
function planePixels(plane: Uint32Array, onDark: boolean): Uint8ClampedArray<ArrayBuffer> {
  const pixels = new Uint8ClampedArray(4 * BINS * BINS);
  let most = 1;
  for (const hits of plane) most = Math.max(most, hits);
  const [red, green, blue] = onDark ? [234, 167, 42] : [154, 91, 0];
  for (let a = 0; a < BINS; a++) {
    for (let c = 0; c < BINS; c++) {
      const hits = plane[a * BINS + c] ?? 0;
      const at = 4 * ((BINS - 1 - c) * BINS + a);
      pixels.set([red, green, blue, hits > 0 ? 24 + (231 * Math.log(1 + hits)) / Math.log(1 + most) : 0], at);
    }
  }
  return pixels;
}

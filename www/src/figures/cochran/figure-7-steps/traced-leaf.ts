/** The leaf of the page, from a bitmap on: traced as any picture that is opened in the Fit tool. */
import { useEffect, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { fitTask } from "#workers/fit/client";
import { FEATURES, KIND, type Leaf } from "../figure-7/leaf-fits";
import { type Bitmap, leafBitmap } from "./boundary";

export interface Steps {
  bitmap: Bitmap;
  /** Pixels on its boundary. */
  count: number;
  /** Points of the traced outline, and the outline ready to be fitted with its feature points. */
  traced: number;
  leaf: Leaf;
}

export function useTracedLeaf(seed: number): { steps: Steps | null; problem: string | null } {
  const [state, setState] = useState<{ seed: number; steps: Steps | null; problem: string | null }>({
    seed,
    steps: null,
    problem: null,
  });
  useEffect(() => {
    const stop = new AbortController();
    stepsOf(seed, stop.signal).then(
      (steps) => setState({ seed, steps, problem: null }),
      (problem) => {
        if (!stop.signal.aborted) setState({ seed, steps: null, problem: wordsOf(problem) });
      },
    );
    return () => stop.abort();
  }, [seed]);
  return state.seed === seed ? state : { steps: null, problem: null };
}

async function stepsOf(seed: number, signal: AbortSignal): Promise<Steps> {
  const grown = await fitTask("grow", { kind: KIND, seed }, { signal });
  const { bitmap, count } = leafBitmap(grown);
  const opened = await fitTask("openFile", { file: await pngOf(bitmap), name: "leaf.png" }, { signal });
  if (opened.kind !== "picture") throw new Error("The bitmap is no picture.");
  opened.bitmap.close();
  const { id } = opened;
  try {
    await fitTask("mask", { id, threshold: 0, petiole: "keep", strokes: [] }, { signal });
    const outline = await fitTask("outline", { id, component: 0 }, { signal });
    const traced = outline.points.length / 2;
    const { points } = await fitTask("prepare", { points: outline.points, smoothing: 0 }, { signal });
    const features = await fitTask("features", { points, count: FEATURES }, { signal });
    return { bitmap, count, traced, leaf: { points, features } };
  } finally {
    void fitTask("closeFile", { id }).catch(() => {});
  }
}

/** Black on white, as the paper's. */
export function imageOf({ width, height, inside }: Bitmap): ImageData {
  const image = new ImageData(width, height);
  inside.forEach((one, i) => {
    image.data.set(one ? [0, 0, 0, 255] : [255, 255, 255, 255], 4 * i);
  });
  return image;
}

function pngOf(bitmap: Bitmap): Promise<Blob> {
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
  canvas.getContext("2d")?.putImageData(imageOf(bitmap), 0, 0);
  return canvas.convertToBlob({ type: "image/png" });
}

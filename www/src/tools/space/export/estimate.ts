/** How much it will be, measured on this device. */
import { useEffect, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { space, spacePart, spaceView } from "#document/space/space";
import type { Repeat, Space } from "#wasm/api";
import { painters } from "#workers/film/crew";
import { Frames, frameRecord } from "#workers/film/frames";
import { pictureAt } from "#workers/film/make";
import { channels } from "#workers/film/opaque";
import { spaceTask } from "#workers/space/client";
import { colours, ground } from "../stage/sight";
import { frameCount, isFilm, litPart, type Plan } from "./plan";

export interface Preview {
  image: ImageData | null;
  /** The part of it that shows something. */
  lit: number;
  /** Milliseconds for one pixel of it that is carved. */
  cost: number | null;
  problem: string | null;
}

const NOTHING: Preview = { image: null, lit: 0.5, cost: null, problem: null };
const BOX = { width: 416, height: 234 };
/** So long after the last change, in milliseconds. */
const REST_MS = 200;

/** The first frame, small. */
export function usePreview({ kind, width, height, from }: Plan): Preview {
  const [preview, setPreview] = useState(NOTHING);
  const film = isFilm(kind);
  useEffect(() => {
    const scene = space.peek();
    const view = spaceView.peek();
    if (!film || !scene || !view) return;
    const stop = new AbortController();
    const scale = Math.min(1, BOX.width / width, BOX.height / height);
    const size = {
      width: Math.max(1, Math.round(width * scale)),
      height: Math.max(1, Math.round(height * scale)),
    };
    const draw = async () => {
      const frames = new Frames(scene);
      try {
        const look = {
          palette: colours.peek(),
          ground: ground.peek(),
          factor: 1 as const,
        };
        const request = pictureAt({ space: scene, view, ...look }, frames, from, size);
        const { data, took } = await spaceTask("measured", request, { lane: 1, signal: stop.signal });
        const cost = leastCost(scene, took / (size.width * size.height));
        const image = new ImageData(data, size.width, size.height);
        setPreview({ image, lit: litPart(data, channels(look.ground)), cost, problem: null });
      } catch (problem) {
        if (!stop.signal.aborted) setPreview({ ...NOTHING, problem: wordsOf(problem) });
      } finally {
        frames.free();
      }
    };
    const timer = setTimeout(() => void draw(), REST_MS);
    return () => {
      clearTimeout(timer);
      stop.abort();
    };
  }, [film, width, height, from]);
  return preview;
}

const costs = new WeakMap<Space, number>();

/** What else the device had to do does not count. */
function leastCost(scene: Space, cost: number): number {
  const least = Math.min(cost, costs.get(scene) ?? cost);
  costs.set(scene, least);
  return least;
}

/** About how many seconds all frames take. */
export function secondsFor(plan: Plan, loop: Repeat, cost: number): number {
  const carved = plan.width * plan.height * (plan.smooth ? 4 : 1);
  // Colouring and writing take about as long again as a picture that is easily carved.
  const each = 0.7 * cost * carved + plan.width * plan.height * 4e-5;
  const hands = painters(carved, navigator.hardwareConcurrency);
  return (each * frameCount(plan, loop)) / hands / 1000;
}

/** How many bytes the parameters of all frames are, from some of them; null where they cannot be told. */
export function parametersBytes(plan: Plan, loop: Repeat): number | null {
  const scene = space.peek();
  const view = spaceView.peek();
  if (!scene || !view) return null;
  let frames: Frames | null = null;
  try {
    frames = new Frames(scene);
    const tried = [0, 0.21, 0.43, 0.68, 1].map((part) => plan.from + part * (plan.to - plan.from));
    let bytes = 0;
    for (const time of tried) bytes += JSON.stringify(frameRecord(scene, time, frames.at(time), view)).length;
    const head = spacePart.peek().packed.length + 300;
    return (bytes / tried.length + 2) * frameCount(plan, loop) + head;
  } catch {
    return null;
  } finally {
    frames?.free();
  }
}

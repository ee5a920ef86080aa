import { effect } from "@preact/signals";
import { stageStyle } from "../canvas/look";
import { mainPainter, picture } from "../canvas/stage";
import type { Pixels } from "../canvas/surface";
import { effectiveView, stageSize } from "../canvas/view";
import type { Scene } from "../engine/api";
import { killWorker } from "../engine/engine";
import { locus, verdict, workers } from "../engine/results";
import { frond } from "../engine/wasm";
import { shown } from "../state/morph";
import { scene } from "../state/scene";

/** What the tests, and the curious, may ask of the running page. */
export interface Hook {
  scene(): Scene;
  backend(): string | null;
  readPixels(): Promise<Pixels>;
  /** The same picture from the CPU, through the adaptive cut: what `readPixels` has to agree with. */
  twin(): Promise<Pixels>;
  /** Share of the locus's samples that are decided, 0 to 1. */
  locusProgress(): number;
  forceLoss(): void;
  killWorker(): void;
  /** Resolves when the picture is complete. */
  drawn(): Promise<void>;
  /** Resolves when the locus is complete too, the verdict is about the picture, and no worker has anything to do. */
  idle(): Promise<void>;
}

declare global {
  interface Window {
    frond?: Hook;
  }
}

export function installHook(): void {
  window.frond = {
    scene: () => structuredClone(scene.peek()),
    backend: () => picture.peek().backend,
    readPixels,
    twin,
    locusProgress: () => locus.peek()?.progress ?? 0,
    forceLoss: () => mainPainter.peek()?.forceLoss(),
    killWorker,
    drawn: () => calm(drawn),
    idle: () => calm(idle),
  };
}

async function readPixels(): Promise<Pixels> {
  const painter = mainPainter.peek();
  if (!painter) throw new Error("There is no picture on this page.");
  return painter.pixels();
}

async function twin(): Promise<Pixels> {
  const { width, height } = await readPixels();
  const { x, y, scale } = effectiveView.peek();
  const view = { x, y, scale: (scale * width) / stageSize.peek().width };
  const { colouring, palette } = stageStyle.peek();
  const data = frond.rasterize({ maps: shown.peek() }, { width, height, view, colouring, palette });
  return { width, height, data };
}

function drawn(): boolean {
  return picture.value.settled;
}

function idle(): boolean {
  return (
    drawn() &&
    (locus.value === null || locus.value.progress === 1) &&
    verdict.value?.stale === false &&
    !workers.value.busy
  );
}

const REST_MS = 160;

/** Resolves when something has held for a while: what is asked after a short rest, such as the strip, counts too. */
function calm(holds: () => boolean): Promise<void> {
  return new Promise((resolve) => {
    let timer: ReturnType<typeof setTimeout> | null = null;
    const stop = effect(() => {
      const now = holds();
      if (timer) clearTimeout(timer);
      timer = now ? setTimeout(end, REST_MS) : null;
    });
    function end() {
      stop();
      resolve();
    }
  });
}

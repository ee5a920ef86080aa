/** `window.frond`: what tests may ask of the running page. */
import { effect } from "@preact/signals";
import { locus, verdict } from "#compute/results";
import { bend, deformation } from "#document/deform/bend";
import { pictureShown } from "#document/deform/picture";
import { linear, selection, shown } from "#document/morph";
import { spaceShown } from "#document/playback";
import { scene } from "#document/scene";
import { weighted } from "#geometry/maps/weighted";
import { shownWeights, stageStyle } from "#stage/picture-style";
import { linearPainter, linearPicture, mainPainter, picture } from "#stage/stage";
import { bentPicture } from "#stage/surface/sheet";
import type { Pixels } from "#stage/surface/surface";
import { effectiveView, stageSize } from "#stage/view";
import type { Scene } from "#wasm/api";
import { loadBends, rasterized } from "#wasm/bend";
import { curvesFetched } from "#wasm/curve";
import { killWorker, workers } from "#workers/pool/engine";
import * as messages from "./messages";

/** The picture on the stage, or the linear one beside it. */
export type Which = "main" | "linear";

/** What the tests, and the curious, may ask of the running page. */
interface Hook {
  scene(): Scene;
  backend(): string | null;
  readPixels(which?: Which): Promise<Pixels>;
  /** The same picture from the CPU, through the adaptive cut: what `readPixels` has to agree with. */
  twin(which?: Which): Promise<Pixels>;
  /** Share of the locus's samples that are decided, 0 to 1. */
  locusProgress(): number;
  forceLoss(): void;
  killWorker(): void;
  /** Resolves when the picture is complete, and the one beside it. */
  drawn(): Promise<void>;
  /**
   * Resolves when the locus is complete too, the verdict is about the picture, no worker has anything to do, and
   * nothing is fetched ahead.
   */
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
    forceLoss: () => {
      if (scene.peek().tool === "space")
        import("#tools/space/stage/state").then((stage) => stage.loseSpace());
      else mainPainter.peek()?.forceLoss();
    },
    killWorker,
    drawn: () => calm(drawn),
    idle: () => calm(idle),
  };
}

async function readPixels(which: Which = "main"): Promise<Pixels> {
  if (scene.peek().tool === "space") return (await import("#tools/space/stage/state")).spacePixels();
  const painter = (which === "main" ? mainPainter : linearPainter).peek();
  if (!painter) throw new Error(messages.thisPageHasNo);
  return painter.pixels();
}

async function twin(which: Which = "main"): Promise<Pixels> {
  const { width, height } = await readPixels(which);
  const ratio = (await readPixels()).width / stageSize.peek().width;
  const { x, y, scale } = effectiveView.peek();
  const view = { x, y, scale: scale * ratio };
  const { colouring, palette, lightGround = false } = stageStyle.peek();
  const maps = (which === "main" ? shown : linear).peek();
  const bent = selection.peek() ? null : bend.peek();
  const photograph = which === "main" ? pictureShown.peek() : null;
  if (photograph) {
    await loadBends();
    return bentPicture(photograph, { bend: bent, parts: deformation.peek().parts, view, width, height });
  }
  const data = await rasterized(weighted(maps, shownWeights.peek()), {
    width,
    height,
    view,
    colouring,
    palette,
    lightGround,
    ...(bent ? { bend: bent } : {}),
  });
  return { width, height, data };
}

function drawn(): boolean {
  // These have a picture of their own, and this one is not on the page.
  if (scene.value.tool === "fit") return true;
  if (scene.value.tool === "space") return spaceShown.value;
  return picture.value.settled && linearPicture.value?.settled !== false;
}

function idle(): boolean {
  return (
    drawn() &&
    (locus.value === null || locus.value.progress === 1) &&
    verdict.value?.stale === false &&
    !workers.value.busy &&
    curvesFetched.value
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

/** The guide: begun when all else is there. */
import { effect } from "@preact/signals";
import { h, render } from "preact";
import { play, playing } from "#document/playback";
import { reducedMotion } from "#document/preferences";
import { lastStep, scene } from "#document/scene";
import { Guide } from "./Guide";
import { seen } from "./seen";
import { greeting } from "./state";
import { STEPS } from "./steps";

/** How far the morph of a first visit plays: a shape on the way, in one piece. */
const FAR = 0.4;

/** `hash` is what the page was opened with: whoever follows a link came for that. */
export function beGuided(hash: string): void {
  const host = document.createElement("div");
  document.body.append(host);
  render(h(Guide, null), host);
  if (hash.length > 1 || seen(STEPS.length) !== null || lastStep()) return;
  greeting.value = true;
  if (!reducedMotion.peek()) playALittle();
}

/** Shows that it moves, and stops; at once where somebody takes it in hand. */
function playALittle(): void {
  play();
  const stop = effect(() => {
    if (scene.value.t < FAR && playing.value) return;
    queueMicrotask(end);
  });
  addEventListener("pointerdown", end, { capture: true });
  addEventListener("keydown", end, { capture: true });
  function end() {
    stop();
    playing.value = false;
    removeEventListener("pointerdown", end, { capture: true });
    removeEventListener("keydown", end, { capture: true });
  }
}

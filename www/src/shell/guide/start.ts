/** The guide: begun when all else is there. */
import { effect } from "@preact/signals";
import { h, render } from "preact";
import { route } from "#document/link";
import { selection } from "#document/morph";
import { play, playing, setT } from "#document/playback";
import { reducedMotion } from "#document/preferences";
import { lastStep, scene } from "#document/scene";
import { openTool, tool } from "#document/tool";
import { inHand, moveBySelf } from "../moving";
import { readParameters } from "../parameters";
import { Guide } from "./Guide";
import css from "./guide.module.css";
import { seen, underWay } from "./seen";
import { goTo, greeted, greeting, rested } from "./state";
import { STEPS } from "./steps";
import { Welcome } from "./Welcome";

/** `hash` is what the page was opened with: a document in it was sent by somebody. */
export function beGuided(hash: string): void {
  const host = document.createElement("div");
  document.body.append(host);
  render(h(Guide, null), host);
  // The room that the page has kept for the word of welcome.
  const { dataset } = document.documentElement;
  const { first = "" } = dataset;
  effect(() => {
    if (greeting.value === null) delete dataset["first"];
    else dataset["first"] = first;
  });
  const left = underWay(STEPS.length);
  if (left !== null && route.peek().page === "studio") {
    openTool("morph");
    goTo(left);
    return;
  }
  if (route.peek().page !== "studio" || seen(STEPS.length) !== null || lastStep()) return;
  const [visit] = performance.getEntriesByType("navigation") as PerformanceNavigationTiming[];
  const sent = hash.length > 1;
  // What was here before the page was loaded again was sent by nobody.
  if (sent && visit && visit.type !== "navigate") return;
  greeting.value = sent ? "sent" : "new";
  welcome();
  leaveWithTool();
  if (!sent) {
    if (!reducedMotion.peek()) playOnce();
  } else if (readParameters(location.search).play === null) moveBySelf("once");
}

/** It has a place of its own in the studio, so that it lies over nothing. */
function welcome(): void {
  const place = document.createElement("div");
  place.className = css["welcome"] ?? "";
  place.dataset["welcome"] = "";
  document.querySelector("main.studio")?.prepend(place);
  render(h(Welcome, null), place);
}

/** Whoever opens another tool, or edits maps, has had the word of welcome: it speaks of what is no longer seen. */
function leaveWithTool(): void {
  const first = tool.peek();
  const stop = effect(() => {
    if (greeting.value !== null && tool.value === first && selection.value === null) return;
    queueMicrotask(() => {
      stop();
      if (greeting.peek() !== null) greeted();
    });
  });
}

/** Shows all of the way, once, and stops at its end; at once where somebody takes it in hand. */
function playOnce(): void {
  play();
  let far = scene.peek().t;
  const stop = effect(() => {
    const { t } = scene.value;
    // What plays turns back at the end.
    if (t >= far && t < 1 && playing.value) {
      far = t;
      return;
    }
    const arrived = playing.value;
    queueMicrotask(() => {
      end();
      if (arrived) setT(1);
      rested.value = arrived;
    });
  });
  const release = inHand(end);
  function end() {
    stop();
    playing.value = false;
    release();
  }
}

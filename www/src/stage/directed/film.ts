/** The film of a morph of graph-directed shapes: small pictures at even times, and what is known of each. */
import { effect, untracked } from "@preact/signals";
import { type Frame, outdated, publish } from "#compute/results";
import { FRAME_HEIGHT, FRAME_WIDTH, FRAMES, namesOf } from "#compute/strip";
import { directedWay } from "#document/directed/directed";
import { fitFor, pathTrack } from "#document/framing";
import { scene } from "#document/scene";
import { RESOLUTION } from "#format/verdict";
import type { Track } from "#geometry/boxes";
import { boxAt } from "#geometry/boxes";
import type { RenderStyle } from "#wasm/core";
import { toError } from "#wasm/error";
import { directedTask } from "#workers/directed/client";
import type { Way } from "#workers/directed/moment";
import { stageStyle } from "../picture-style";
import { wayFacts } from "./known";
import { directedLook } from "./options";
import { toldOf } from "./told";

const SETTLE_MS = 150;
/** CSS pixels. */
const MARGIN = 4;
const film = publish.standInFilm;

/** Keeps the film up to date. Returns the end of it. */
export function watchFilm(): () => void {
  let shapes = "";
  const stop = effect(() => {
    const way = directedWay.value;
    const track = pathTrack.value;
    const style = stageStyle.value;
    if (!way) return;
    const kept = untracked(() => film.value);
    const before = shapes;
    shapes = namesOf(scene.peek());
    film.value = Array.from({ length: FRAMES }, (_, i) => {
      const now = { t: i / (FRAMES - 1), verdict: null, bitmap: kept[i]?.bitmap ?? null, stale: true };
      return outdated(now, shapes !== before);
    });
    const end = new AbortController();
    const timer = setTimeout(() => void make(way, track, style, end.signal), SETTLE_MS);
    return () => {
      clearTimeout(timer);
      end.abort();
    };
  });
  // What is proved of all of the way holds at each of these moments.
  const prove = effect(() => {
    const facts = wayFacts.value;
    if (facts?.proof) film.value = untracked(() => film.value).map((frame) => proved(frame, facts.way));
  });
  return () => {
    stop();
    prove();
    film.value = [];
  };
}

/** A frame with what the proof of its way says of it, where there is one. */
function proved(frame: Frame, way: Way): Frame {
  const facts = wayFacts.peek();
  if (!frame.verdict || !facts) return frame;
  const [verdict = null] = toldOf([frame.verdict], { ...way, t: frame.t }, facts.way, facts.proof);
  return { ...frame, verdict };
}

/** One after the other: first what is seen, then what is known. */
async function make(way: Way, track: Track, style: RenderStyle, signal: AbortSignal): Promise<void> {
  const put = (t: number, change: Partial<Frame>) => {
    if (signal.aborted) return;
    film.value = film.peek().map((frame) => (frame.t === t ? { ...frame, ...change } : frame));
  };
  const moments = film.peek().map(({ t }) => t);
  const ratio = Math.min(2, globalThis.devicePixelRatio || 1);
  const size = { width: Math.round(FRAME_WIDTH * ratio), height: Math.round(FRAME_HEIGHT * ratio) };
  const edge = MARGIN * ratio;
  const insets = { top: edge, right: edge, bottom: edge, left: edge };
  for (const t of moments) {
    const view = fitFor(boxAt(track, t), size, insets);
    const options = { ...size, view, ...directedLook(style.colouring, style.palette) };
    const bitmap = await directedTask("moment", { moment: { ...way, t }, options }, { signal }).catch(
      () => null,
    );
    if (signal.aborted) return;
    put(t, { bitmap, stale: false });
  }
  for (const t of moments) {
    const asked = { moment: { ...way, t }, epsilon: RESOLUTION };
    try {
      const [verdict = null] = (await directedTask("known", asked, { lane: 1, signal })).states;
      put(t, { verdict: proved({ t, verdict, bitmap: null, stale: false }, way).verdict });
    } catch (problem) {
      if (signal.aborted) return;
      if (toError(problem).code !== "no-attractor") continue;
      put(t, { verdict: { verdict: "no-attractor", gap: { lower: 0, upper: 0 }, diameter: 0 } });
    }
  }
}

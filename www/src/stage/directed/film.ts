/** The film of a morph of graph-directed shapes: small pictures at even times, and what is known of each. */
import { effect, untracked } from "@preact/signals";
import { type Frame, outdated, publish } from "#compute/results";
import { FRAME_HEIGHT, FRAME_WIDTH, FRAMES, namesOf } from "#compute/strip";
import { directedWay } from "#document/directed/directed";
import { fitFor, pathTrack } from "#document/framing";
import { scene } from "#document/scene";
import { RESOLUTION, type Told } from "#format/verdict";
import type { Track } from "#geometry/boxes";
import { boxAt } from "#geometry/boxes";
import type { RenderStyle } from "#wasm/core";
import { toError } from "#wasm/error";
import { directedTask } from "#workers/directed/client";
import type { Way } from "#workers/directed/moment";
import { stageStyle } from "../picture-style";
import { NONE, toldAlways, wayFacts } from "./known";
import { directedLook } from "./options";

const SETTLE_MS = 150;
/** CSS pixels. */
const MARGIN = 4;
const film = publish.standInFilm;

/** Keeps the film up to date. Returns the end of it. */
export function watchFilm(): () => void {
  let shapes = "";
  let last: Way | null = null;
  const stops = [
    effect(() => {
      const way = directedWay.value;
      const track = pathTrack.value;
      const style = stageStyle.value;
      if (!way) return;
      const kept = untracked(() => film.value);
      const before = shapes;
      shapes = namesOf(scene.peek());
      const coloured = last === way;
      last = way;
      film.value = Array.from({ length: FRAMES }, (_, i) => {
        const now = { t: i / (FRAMES - 1), verdict: null, bitmap: null, ...kept[i], stale: true };
        return outdated(now, shapes !== before, coloured);
      });
      return soon((signal) => draw(way, track, style, signal));
    }),
    // What is seen and what is known have workers of their own.
    effect(() => {
      const way = directedWay.value;
      return way ? soon((signal) => judge(way, signal)) : undefined;
    }),
    effect(() => {
      const verdict = toldAlways.value;
      if (verdict) untracked(() => change((frame) => ({ ...frame, verdict })));
    }),
  ];
  return () => {
    for (const stop of stops) stop();
    film.value = [];
  };
}

/** Begins when there is rest. Returns the end of it. */
function soon(begin: (signal: AbortSignal) => Promise<void>): () => void {
  const end = new AbortController();
  const timer = setTimeout(() => void begin(end.signal), SETTLE_MS);
  return () => {
    clearTimeout(timer);
    end.abort();
  };
}

const change = (to: (frame: Frame) => Frame) => {
  film.value = film.peek().map(to);
};

const put = (t: number, part: Partial<Frame>) => {
  change((frame) => (frame.t === t ? { ...frame, ...part } : frame));
};

async function draw(way: Way, track: Track, style: RenderStyle, signal: AbortSignal): Promise<void> {
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
}

/** Wide gaps are found in a tenth of the time that it takes to know of narrow ones. */
const ROUGH = 1 / 100;

/** First, of every moment, whether a look that takes little time tells; then all that is known. */
export async function judge(way: Way, signal: AbortSignal): Promise<void> {
  const moments = film.peek().map(({ t }) => t);
  for (const t of moments) {
    const verdict = await judged(way, t, ROUGH, signal);
    if (signal.aborted) return;
    // What only comes near to being whole at this fineness is not told.
    if (verdict && verdict.verdict !== "touching" && verdict.verdict !== "undecided") put(t, { verdict });
  }
  const open = new Set(film.peek().flatMap(({ t, verdict }) => (verdict ? [] : [t])));
  for (const t of [...open, ...moments.filter((t) => !open.has(t))]) {
    const verdict = await judged(way, t, RESOLUTION, signal);
    if (signal.aborted) return;
    // A gap that was found stays, where there is not the time to find it anew.
    if (verdict && (verdict.verdict !== "undecided" || open.has(t))) put(t, { verdict });
  }
}

/** What is known of a moment; null where it cannot be had. */
async function judged(way: Way, t: number, epsilon: number, signal: AbortSignal): Promise<Told | null> {
  if (wayFacts.peek()?.way === way && toldAlways.peek()) return toldAlways.peek();
  try {
    const task = directedTask("known", { moment: { ...way, t }, epsilon }, { lane: 1, signal });
    return (await task).states[0] ?? null;
  } catch (problem) {
    const { code } = toError(problem);
    return signal.aborted || code !== "no-attractor" ? null : NONE;
  }
}

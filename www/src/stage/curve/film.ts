/**
 * The film of a closed curve's morph: small pictures at even times, made one after another while there is nothing else
 * to do.
 */
import { effect, untracked } from "@preact/signals";
import { type Frame, publish } from "#compute/results";
import { FRAME_HEIGHT, FRAME_WIDTH, FRAMES, namesOf } from "#compute/strip";
import { curveMorph } from "#document/curve/curve";
import { photographsSeen } from "#document/curve/photographs";
import { pathTrack } from "#document/framing";
import { scene } from "#document/scene";
import { toldOf } from "#format/verdict";
import { boxAt } from "#geometry/boxes";
import { STATE } from "#geometry/states";
import { stageStyle } from "../picture-style";
import { type Carried, carriedOn } from "./photographs/carried";
import { curveThumb } from "./thumb";

const SETTLE_MS = 90;
const film = publish.standInFilm;

/** Keeps the film up to date. Returns the end of it. */
export function watchFilm(): () => void {
  let timer: ReturnType<typeof setTimeout> | null = null;
  let shapes = "";
  const stop = effect(() => {
    const morph = curveMorph.value;
    const track = pathTrack.value;
    const { palette } = stageStyle.value;
    const photographs = photographsSeen.value;
    if (timer) clearTimeout(timer);
    const kept = untracked(() => film.value);
    const before = shapes;
    shapes = namesOf(scene.peek());
    const frames: Frame[] = Array.from({ length: FRAMES }, (_, i) => ({
      t: i / (FRAMES - 1),
      // By construction, at every moment.
      verdict: toldOf(STATE.connected, 0),
      bitmap: shapes === before ? (kept[i]?.bitmap ?? null) : null,
      stale: true,
    }));
    film.value = frames;
    let next = 0;
    let carried: Carried | null = null;
    const step = () => {
      const frame = frames[next];
      if (!morph || morph !== curveMorph.peek() || !frame) return;
      if (next === 0) carried = carriedOn(morph, photographs);
      const bitmap = curveThumb(
        morph,
        frame.t,
        boxAt(track, frame.t),
        { width: FRAME_WIDTH, height: FRAME_HEIGHT },
        palette,
        carried,
      );
      const made = { ...frame, bitmap, stale: false };
      film.value = film.peek().map((old) => (old.t === made.t ? made : old));
      next++;
      timer = setTimeout(step);
    };
    timer = setTimeout(step, SETTLE_MS);
  });
  return () => {
    if (timer) clearTimeout(timer);
    stop();
    film.value = [];
  };
}

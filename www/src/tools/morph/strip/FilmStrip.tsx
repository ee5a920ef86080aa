import { computed, type ReadonlySignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { type Frame, sought, standInFilm, strip } from "#compute/results";
import { scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import { percent } from "#format/path-words";
import { stateOf, verdictPhrase } from "#format/verdict";
import { isBroken } from "#geometry/states";
import { media } from "#style/media";
import { Thumbnail } from "#ui/shapes/Thumbnail";
import type { Verdict } from "#wasm/api";
import { scrubTo } from "../edits";
import * as messages from "../messages";
import css from "./strip.module.css";

const phone = media("(max-width: 37.4375em)");

/** As many frames as there is room for: seven on a phone. */
export const frames: ReadonlySignal<readonly Frame[]> = computed(() => {
  const all = standIn.value ? standInFilm.value : strip.value;
  return phone.value ? evenly(all, 7) : all;
});

/** The frame that is nearest to the present moment. */
const here: ReadonlySignal<number> = computed(() => {
  const { t } = scene.value;
  const away = frames.value.map((frame) => Math.abs(frame.t - t));
  return Math.max(0, away.indexOf(Math.min(...away)));
});

/** What is written on a still that does not hold, also where that is not seen, and on one of which nobody knows. */
const MARKS: Partial<Record<Verdict, string>> = {
  disconnected: messages.inPieces,
  "no-attractor": messages.noAttractor,
  undecided: messages.notDecided,
};

/** Stills of the whole morph: press one to go there; those that are seen to be broken are hatched. */
export function FilmStrip() {
  const list = useRef<HTMLOListElement>(null);
  const all = frames.value;
  const nearest = here.value;

  const walk = (event: KeyboardEvent) => {
    const to = { ArrowRight: nearest + 1, ArrowLeft: nearest - 1, Home: 0, End: all.length - 1 }[event.key];
    const frame = to === undefined ? undefined : all[to];
    if (to === undefined || frame === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    scrubTo(frame.t);
    list.current?.querySelectorAll<HTMLButtonElement>("button")[to]?.focus();
  };

  return (
    <ol class="film" ref={list} onKeyDown={walk} aria-label={messages.filmMorph}>
      {all.map((frame, index) => {
        // Of a way that only stands in until one is found nothing is said.
        const verdict = sought.value ? null : frame.verdict;
        const broken = verdict !== null && isBroken(stateOf(verdict));
        const mark = verdict ? MARKS[verdict.verdict] : undefined;
        const known = frame.stale ? messages.pictureLoading : verdictPhrase(verdict);
        const words = `${percent(frame.t)}: ${known}`;
        return (
          <li key={frame.t}>
            <button
              type="button"
              class={`frame ${broken ? "broken" : ""} ${frame.stale ? "stale" : ""}`}
              tabIndex={index === nearest ? 0 : -1}
              aria-current={index === nearest ? "true" : undefined}
              aria-label={messages.atMoment(words)}
              title={words}
              onClick={() => scrubTo(frame.t)}
            >
              <Thumbnail bitmap={frame.bitmap} />
              {mark !== undefined && (
                <span class={css["frame-mark"]} aria-hidden="true">
                  {mark}
                </span>
              )}
            </button>
          </li>
        );
      })}
    </ol>
  );
}

/** At most `count` items, evenly spread, with the first and the last among them. */
export function evenly<T>(items: readonly T[], count: number): readonly T[] {
  if (items.length <= count) return items;
  return Array.from(
    { length: count },
    (_, i) => items[Math.round((i * (items.length - 1)) / Math.max(1, count - 1))],
  ).filter((item): item is T => item !== undefined);
}

import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { uvAt } from "#geometry/path";
import { Formula } from "../../kit/frame/formula";
import layout from "../../kit/frame/layout.module.css";
import { VerdictChip } from "../../kit/frame/verdict";
import { type Breakage, breakage } from "../../kit/maps/breakage";
import { boxAround, framesAlong, mapsAt } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";
import { Strip } from "../../kit/picture/stills";
import { Time, type useTime } from "../../kit/time/time";
import { useStates, useValue, useVerdict } from "../../kit/workers";
import { dragon, ends } from "./dragon";
import css from "./film.module.css";

const FRAMES = 10;

interface FilmProps {
  name: string;
  points: readonly Uv[];
  time: ReturnType<typeof useTime>;
  broken: Breakage | null;
  /** What stands beside the picture, for the point of the path at which it is. */
  beside?: (at: Uv) => ComponentChildren;
}

/** A morph along a path: the picture of one moment, the slider, and stills of all. */
export function Film({ name, points, time, broken, beside }: FilmProps) {
  const pair = useValue(ends);
  const { t } = time;
  const at = useMemo(() => uvAt(points, t), [points, t]);
  const maps = useMemo(() => mapsAt(pair, at), [pair, at]);
  const judged = useVerdict(maps);
  const frames = useMemo(() => framesAlong(pair, points, FRAMES), [pair, points]);
  const box = useMemo(() => boxAround(frames.map((frame) => frame.maps)), [frames]);
  return (
    <>
      <div class={`${layout["panel"]} ${css["film-picture"]}`}>
        <div class={css["film-top"]}>
          <Picture
            maps={maps}
            box={box}
            label={`${name} at t = ${fixed(t)}: ${verdictPhrase(judged?.answer ?? null)}`}
          />
          {beside?.(at)}
        </div>
        <div class={css["film-foot"]}>
          <VerdictChip answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
          <span class="number">
            <Formula>u</Formula> {fixed(at[0])} <Formula>v</Formula> {fixed(at[1])}
          </span>
        </div>
      </div>
      <Time time={time} words={verdictPhrase(judged?.answer ?? null)} breaks={broken?.stretches ?? []} />
      <Strip label={`${name}: frames`} frames={frames} box={box} t={t} onPick={time.go} />
    </>
  );
}

/** How much of a way is broken, or null until it is known. */
export function useBroken(points: readonly Uv[] | null): Breakage | null {
  const pair = useValue(ends);
  const way = useMemo(() => (points ? { ...pair, options: {}, points } : null), [pair, points]);
  const states = useStates(way);
  return useMemo(() => (states ? breakage(states) : null), [states]);
}

/** The name of the present dragon in a sentence. */
export function dragonWords(): string {
  return {
    "dragon-3": "Heighway’s dragon",
    terdragon: "the terdragon",
    "terdragon-mirrored": "the mirrored terdragon",
  }[dragon.value];
}

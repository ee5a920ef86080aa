import { fixed } from "#format/numbers";
import type { Stretch } from "#geometry/states";
import { Slider } from "#ui/controls/Slider";
import { SliderBreaks } from "#ui/controls/SliderMarks";
import { PlayButton } from "#ui/strip/PlayButton";
import { Formula } from "../frame/formula";
import { number } from "../state/fields";
import { useKept } from "../state/kept";
import { usePlay } from "./play";
import css from "./time.module.css";

const SECONDS = 8;
/** As it stands in an address. */
const MOMENT = number(0, 1, 3);

/** The moment of a morph, and what moves it. */
export function useTime(start: number) {
  const [t, setT] = useKept("t", start, MOMENT);
  const player = usePlay((seconds) => {
    const next = Math.min(1, t + seconds / SECONDS);
    setT(next);
    return next < 1;
  });
  const toggle = () => {
    if (!player.playing && t >= 1) setT(0);
    player.toggle();
  };
  const go = (next: number) => {
    player.stop();
    setT(next);
  };
  return { t, go, playing: player.playing, toggle };
}

interface TimeProps {
  time: ReturnType<typeof useTime>;
  /** What is said of the moment beside its number. */
  words: string;
  breaks?: readonly Stretch[];
}

/** Play, and a slider over the whole morph with its broken stretches marked. */
export function Time({ time, words, breaks = [] }: TimeProps) {
  return (
    <div class={css["figure-time"]}>
      <PlayButton playing={time.playing} onToggle={time.toggle} />
      <Slider
        label="Time t"
        value={time.t}
        step={0.01}
        valueText={`t = ${fixed(time.t)}, ${words}`}
        onChange={time.go}
      >
        <SliderBreaks breaks={breaks.map(({ t0, t1 }) => [t0, t1])} />
      </Slider>
      <output class="number">
        <Formula>t</Formula> {fixed(time.t)}
      </output>
    </div>
  );
}

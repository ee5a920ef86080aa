import { fixed } from "#format/numbers";
import { Slider } from "#ui/controls/Slider";
import { PlayButton } from "#ui/strip/PlayButton";
import { Formula } from "../../kit/frame/formula";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { usePlay } from "../../kit/time/play";
import timeCss from "../../kit/time/time.module.css";

const SECONDS = 6;
/** As it stands in an address. */
const MOMENT = number(0, 1, 3);

/** The moment of something that goes round and round. */
export function useSway(start: number) {
  const [t, setT] = useKept("t", start, MOMENT);
  const player = usePlay((seconds) => {
    setT((t + seconds / SECONDS) % 1);
    return true;
  });
  const go = (next: number) => {
    player.stop();
    setT(next);
  };
  return { t, go, playing: player.playing, toggle: player.toggle };
}

/** Play, and a slider over one time round. */
export function Sway({ sway }: { sway: ReturnType<typeof useSway> }) {
  return (
    <div class={timeCss["figure-time"]}>
      <PlayButton playing={sway.playing} onToggle={sway.toggle} />
      <Slider
        label="Time t"
        value={sway.t}
        step={0.01}
        valueText={`t = ${fixed(sway.t)} of one time to and fro`}
        onChange={sway.go}
      />
      <output class="number">
        <Formula>t</Formula> {fixed(sway.t)}
      </output>
    </div>
  );
}

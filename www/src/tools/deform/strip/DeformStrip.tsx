import "#ui/strip/strip.css";
import { computed } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { changeDeformation, deformation, movesAt, phasePlaying } from "#document/deform/bend";
import { keyNear } from "#document/deform/keys";
import { Slider } from "#ui/controls/Slider";
import { narrow } from "#ui/media";
import { KeyTrack } from "#ui/strip/KeyTrack";
import { PlayButton } from "#ui/strip/PlayButton";
import { pausePhase, playPhase, scrubPhase } from "../clock";
import { withKey, withKeyAt } from "../deform-edits";
import { momentWords, percentWords } from "../deform-text";
import { unbent } from "../facts";
import * as messages from "../messages";
import { MeshIcon } from "./MeshIcon";
import css from "./strip.module.css";
import { removeKey, TimeOptions } from "./TimeOptions";

const keys = computed(() => deformation.value.keys);
/** The key at the present moment, or -1. */
const here = computed(() => keyNear(deformation.value, deformation.value.phase));

function go(index: number): void {
  const key = keys.peek()[index];
  if (key) scrubPhase(key.at);
}

function move(index: number, to: number): void {
  pausePhase();
  changeDeformation((d) => withKeyAt(d, index, to), { gesture: `key ${index}` });
}

function add(at: number): void {
  pausePhase();
  changeDeformation((d) => withKey(d, at, movesAt(d.keys, at, d.loop)));
}

/** The key frames of the time line, each with its mesh. */
function Keys() {
  const all = keys.value;
  return (
    <KeyTrack
      label={messages.keyframes}
      keys={all}
      length={1}
      here={all.length > 1 ? here.value : -1}
      reach={Math.max(0, here.value)}
      step={0.01}
      about={(index) => {
        const at = all[index]?.at ?? 0;
        return {
          role: "slider",
          "aria-label": messages.keyOf(index + 1, all.length),
          "aria-valuenow": Math.round(1000 * at) / 10,
          "aria-valuemin": 0,
          "aria-valuemax": 100,
          "aria-valuetext": percentWords(at),
          title: messages.keyAt(index + 1, percentWords(at)),
        };
      }}
      go={go}
      move={move}
      remove={removeKey}
      add={add}
      Picture={MeshIcon}
    >
      {all.length === 1 && <p class={css["keys-hint"]}>{messages.oneGridForAllTimes}</p>}
    </KeyTrack>
  );
}

/** Time: play, scrub, and the key frames of the mesh. */
export function DeformStrip() {
  useEffect(() => pausePhase, []);
  if (unbent.value) return null;
  const { phase } = deformation.value;
  return (
    <section class="strip" aria-label={messages.time}>
      <Play />
      <div class={`strip-film ${css["key-film"]}`}>
        <Slider
          class="key-scrub"
          label={messages.time}
          value={phase}
          step={0.01}
          valueText={momentWords(deformation.value)}
          onChange={scrubPhase}
        />
        <Keys />
      </div>
      {!narrow.value && <TimeOptions />}
    </section>
  );
}

function Play() {
  const on = phasePlaying.value;
  const still = deformation.value.keys.length < 2;
  return (
    <PlayButton
      playing={on}
      onToggle={() => (on ? pausePhase() : playPhase())}
      still={still ? messages.singleKeyframeDoesNot : undefined}
    />
  );
}

import { computed } from "@preact/signals";
import { changeDeformation, deformation, movesAt } from "#document/deform/bend";
import { keyNear } from "#document/deform/keys";
import { KeyTrack } from "#ui/strip/KeyTrack";
import { withKey, withKeyAt } from "../changes";
import { pausePhase, scrubPhase } from "../clock";
import * as messages from "../messages";
import { MeshIcon } from "./MeshIcon";
import css from "./strip.module.css";
import { removeKey } from "./TimeOptions";
import { percentWords } from "./words";

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
export function Keys() {
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

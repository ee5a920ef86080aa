import { PlayButton } from "#ui/strip/PlayButton";
import "#ui/strip/strip.css";
import { useEffect } from "preact/hooks";
import { deformation, phasePlaying } from "#document/deform/bend";
import { Slider } from "#ui/controls/Slider";
import { narrow } from "#ui/media";
import { pausePhase, playPhase, scrubPhase } from "../clock";
import { unbent } from "../facts";
import * as messages from "../messages";
import { Keys } from "./Keys";
import css from "./strip.module.css";
import { TimeOptions } from "./TimeOptions";
import { momentWords } from "./words";

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

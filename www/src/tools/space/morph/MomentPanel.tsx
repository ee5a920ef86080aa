import { endGesture } from "#document/scene";
import { timeline } from "#document/space/space";
import { fixed } from "#format/numbers";
import { percent } from "#format/path-words";
import { IconButton } from "#ui/controls/Button";
import { Slider } from "#ui/controls/Slider";
import { SliderBreaks } from "#ui/controls/SliderMarks";
import { PercentField } from "#ui/strip/PercentField";
import * as messages from "../messages";
import { Holds } from "./Holds";
import css from "./morph3.module.css";
import { morphPlaying, pause, play } from "./play";
import { goTo, stateNow } from "./way";
import { check, moment, uv } from "./work";

/** Where along the path it is, and whether what is seen there is in one piece. */
export function MomentPanel() {
  const t = moment.value;
  const keyed = timeline.value?.keys.some((key) => key.t !== undefined) ?? false;
  const on = morphPlaying.value;
  const [u, v] = uv.value;
  return (
    <section class={css["morph3-part"]} aria-label={messages.positionOnPath}>
      <div class={css["morph3-time"]}>
        <IconButton
          class="play"
          icon={on ? "pause" : "play"}
          label={on ? messages.pauseMorph : messages.playMorph}
          disabled={keyed}
          onClick={on ? pause : play}
        />
        <Slider
          label={messages.timeAlongPath}
          value={t}
          step={0.01}
          valueText={`${percent(t)}, ${stateNow()}`}
          onChange={(next) => {
            pause();
            goTo(next);
          }}
          onDone={endGesture}
        >
          <SliderBreaks breaks={check.value?.breaks ?? []} />
        </Slider>
        <PercentField
          label={messages.timeAlongPathIn}
          value={t}
          onChange={(next) => {
            pause();
            goTo(next);
          }}
          onDone={endGesture}
        />
      </div>
      <p class="hint number">
        <span class="symbol">u</span> {messages.turnsAndStretches(fixed(u))} <span class="symbol">v</span>{" "}
        {messages.moves(fixed(v))}
      </p>
      {keyed && <p class="notes">{messages.timelineControlsThisWhat}</p>}
      <Holds />
    </section>
  );
}

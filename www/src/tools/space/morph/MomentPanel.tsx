import { endGesture } from "#document/scene";
import { timeline } from "#document/space/space";
import { fixed } from "#format/numbers";
import { percent } from "#format/path-words";
import { IconButton } from "#ui/controls/Button";
import { Slider } from "#ui/controls/Slider";
import { SliderBreaks } from "#ui/controls/SliderMarks";
import { PercentField } from "#ui/strip/PercentField";
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
    <section class={css["morph3-part"]} aria-label="Where along the path">
      <div class={css["morph3-time"]}>
        <IconButton
          class="play"
          icon={on ? "pause" : "play"}
          label={on ? "Pause the morph" : "Play the morph"}
          disabled={keyed}
          onClick={on ? pause : play}
        />
        <Slider
          label="Place along the path"
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
          label="Place along the path in percent"
          value={t}
          onChange={(next) => {
            pause();
            goTo(next);
          }}
          onDone={endGesture}
        />
      </div>
      <p class="hint number">
        <span class="symbol">u</span> {fixed(u)} turns and stretches, <span class="symbol">v</span> {fixed(v)}{" "}
        moves
      </p>
      {keyed && (
        <p class="notes">
          The time line moves it: what is set here is remembered at its moment, and it plays below.
        </p>
      )}
      <Holds />
    </section>
  );
}

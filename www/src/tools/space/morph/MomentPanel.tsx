import { endGesture } from "#document/scene";
import { timeline } from "#document/space/space";
import { fixed } from "#format/numbers";
import { percent } from "#format/path-words";
import { reasonWords } from "#format/reason";
import { verdictWords } from "#format/verdict";
import { IconButton } from "#ui/controls/Button";
import { Slider } from "#ui/controls/Slider";
import { SliderBreaks } from "#ui/controls/SliderMarks";
import { VerdictSign } from "#ui/shapes/VerdictSign";
import { PercentField } from "#ui/strip/PercentField";
import * as messages from "../messages";
import css from "./morph3.module.css";
import { morphPlaying, pause, play } from "./play";
import { goTo, stateNow } from "./waypoints";
import { check, judged, moment, uv } from "./work";

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

/** Whether what is seen is in one piece, in words; and why, where there is a reason. */
function Holds() {
  const now = judged.value;
  const words = verdictWords(now?.answer ?? null);
  const reason = now?.answer.reason;
  return (
    <div class={css["morph3-holds"]}>
      <p class={css["morph3-verdict"]} data-stale={now?.stale ? "" : undefined} data-testid="space-verdict">
        <VerdictSign tone={words.tone} />
        <strong>{words.text}</strong>
        {words.aside !== "" && <span class="dim">{words.aside}</span>}
      </p>
      {reason && (
        <details class={css["morph3-why"]}>
          <summary>{messages.why}</summary>
          <p class="hint">{reasonWords(reason)}</p>
        </details>
      )}
    </div>
  );
}

import { PercentField } from "#ui/strip/PercentField";
import { PlayButton } from "#ui/strip/PlayButton";
import "#ui/strip/strip.css";
import "./strip.css";
import { computed } from "@preact/signals";
import { along, pathBreaks, sought } from "#compute/results";
import { locusView } from "#document/morph";
import { loop, pause, play, playing, speed } from "#document/playback";
import { endGesture, scene } from "#document/scene";
import { standIn, standInWords } from "#document/stand-in";
import { percent } from "#format/path-words";
import { shareWords } from "#format/verdict";
import { IconButton } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { Slider } from "#ui/controls/Slider";
import { narrow } from "#ui/media";
import { scrubTo } from "../edits";
import { FamilyStrip } from "../later";
import { stateNow } from "../locus/path/waypoints";
import * as messages from "../messages";
import { FilmStrip, frames } from "./FilmStrip";
import css from "./strip.module.css";

/** Time: play, scrub, and the film of the whole morph; of a family, the way of its parameter. */
export function MorphStrip() {
  if (locusView.value.family === "polygon" && !standIn.value) return <FamilyStrip />;
  return (
    <section
      class="strip"
      aria-label={messages.time}
      style={{ "--frames": String(Math.max(1, frames.value.length)) }}
    >
      <Play />
      <div class={`strip-film ${offPath.value ? css["off-path"] : ""}`}>
        <Scrub />
        <FilmStrip />
      </div>
      {!narrow.value && <PlaybackOptions />}
    </section>
  );
}

function Play() {
  const on = playing.value;
  return <PlayButton playing={on} onToggle={() => (on ? pause() : play())} />;
}

/** Whether the picture shows something else than the path at the present moment. */
const offPath = computed(
  () => !standIn.value && (locusView.value.at !== undefined || locusView.value.family === "polygon"),
);

/** What is wrong with the path; what stands in place of the systems has none. */
const faults = computed(() =>
  standIn.value || sought.value
    ? { breaks: [], worst: null }
    : { breaks: pathBreaks.value, worst: along.value?.worst ?? null },
);

/** The moment in words, and what is known of it. */
function timeWords(t: number): string {
  if (offPath.value) return messages.offPath(percent(t));
  if (sought.value) return messages.searchingPath(percent(t));
  return `${percent(t)}, ${standIn.value ? standInWords.value : stateNow()}`;
}

function Scrub() {
  const { t } = scene.value;
  const off = offPath.value;
  const { breaks, worst } = faults.value;
  return (
    <Slider
      class={`${css["scrub"]} ${sought.value ? css["open"] : ""}`}
      label={messages.time}
      value={t}
      step={0.01}
      valueText={timeWords(t)}
      onChange={scrubTo}
      onDone={endGesture}
    >
      {breaks.map(({ t0, t1 }) => (
        <span
          key={`${t0}-${t1}`}
          class={css["scrub-break"]}
          style={{ left: `${100 * t0}%`, width: `max(3px, ${100 * (t1 - t0)}%)` }}
        />
      ))}
      {off && (
        // On the half where the thumb is not.
        <span class={css["scrub-off"]} style={{ left: t < 0.5 ? "75%" : "25%" }}>
          {messages.pictureOffPath}
        </span>
      )}
      {worst && (
        <span
          class={css["scrub-worst"]}
          style={{ left: `${100 * worst.t}%` }}
          title={messages.worstAt(shareWords(worst.gap), percent(worst.t))}
        />
      )}
    </Slider>
  );
}

const SPEEDS = [
  { value: "0.25", label: "¼×" },
  { value: "0.5", label: "½×" },
  { value: "1", label: "1×" },
  { value: "2", label: "2×" },
] as const;

/** Place in per cent, loop and speed. */
export function PlaybackOptions() {
  return (
    <div class="playback">
      <PercentField
        label={messages.timeInPercent}
        value={scene.value.t}
        onChange={scrubTo}
        onDone={endGesture}
      />
      <IconButton
        icon="loop"
        label={messages.loopBackAndForth}
        kind="quiet"
        pressed={loop.value}
        onClick={() => {
          loop.value = !loop.value;
        }}
      />
      <Segmented
        label={messages.speed}
        value={SPEEDS.find((option) => Number(option.value) === speed.value)?.value ?? "1"}
        options={SPEEDS}
        onChange={(next) => {
          speed.value = Number(next);
        }}
      />
    </div>
  );
}

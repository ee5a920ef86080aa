import "#ui/strip/strip.css";
import { useEffect, useState } from "preact/hooks";
import { changeTimeline, EMPTY_LINE } from "#document/space/edits";
import { moment, space, spacePlaying, timeline } from "#document/space/space";
import { filmProgress, openFilm } from "#film/open";
import { Button } from "#ui/controls/Button";
import { Slider } from "#ui/controls/Slider";
import { useOwnId } from "#ui/id";
import { narrow } from "#ui/media";
import { Menu } from "#ui/overlay/Menu";
import { PlayButton } from "#ui/strip/PlayButton";
import { pauseSpace, scrubSpace, togglePlay } from "./clock";
import { fly } from "./flight/flight";
import { KeyOptions, SetKey } from "./keys/KeyOptions";
import { Keys } from "./keys/Keys";
import { attempt, removeAllKeys, stretch } from "./keys/keys";
import { watchKeys } from "./keys/pictures";
import * as messages from "./messages";
import { openAnimation } from "./saved/open";
import { LoopMenu, TimeNumbers } from "./TimeFields";
import css from "./time.module.css";
import { momentWords } from "./time-text";

/** Time: play, scrub, and the keys. */
export function TimeStrip() {
  useEffect(() => {
    const end = watchKeys();
    return () => {
      end();
      pauseSpace();
    };
  }, []);
  return (
    <section class={`strip ${css["space-strip"]}`} aria-label={messages.time}>
      <Play />
      <div class={css["space-film"]}>
        <Scrub />
        <Track />
      </div>
      {narrow.value ? <FewOptions /> : <AllOptions />}
    </section>
  );
}

function Play() {
  const still = (timeline.value?.keys.length ?? 0) < 2;
  return (
    <PlayButton
      playing={spacePlaying.value}
      onToggle={togglePlay}
      still={still ? messages.setTwoKeyframesOr : undefined}
    />
  );
}

function Scrub() {
  const line = timeline.value ?? space.value?.timeline ?? EMPTY_LINE;
  return (
    <Slider
      class="key-scrub"
      label={messages.time}
      value={Math.min(line.seconds, moment.value)}
      min={0}
      max={line.seconds}
      step={0.1}
      valueText={momentWords(timeline.value, moment.value)}
      onChange={scrubSpace}
    />
  );
}

function Track() {
  const line = timeline.value;
  if (line) return <Keys line={line} />;
  return (
    <div class={css["space-no-keys"]}>
      <p class="hint">
        {messages.noAnimationYet}
        <span class={css["more"]}> {messages.setKeyframeMoveTo}</span>
      </p>
      <Button disabled={!space.value} onClick={() => fly("through")}>
        {messages.flyThrough}
      </Button>
    </div>
  );
}

function AllOptions() {
  const id = useOwnId("time-problem");
  const [problem, setProblem] = useState<string | null>(null);
  const problems = { id, tell: setProblem };
  return (
    <div class={css["space-time-options"]}>
      {problem !== null && (
        <p class={css["time-problem"]} id={id} role="alert">
          {problem}
        </p>
      )}
      <div class={css["time-row"]}>
        <TimeNumbers problems={problems} />
        <LoopMenu />
        <TimeMenu />
      </div>
      <div class={css["time-row"]}>
        <KeyOptions problems={problems} />
        <ExportButton />
      </div>
    </div>
  );
}

/** Where there is little room the numbers are in the panel. */
function FewOptions() {
  return (
    <div class={css["space-few-options"]}>
      <SetKey short />
      <TimeMenu all />
    </div>
  );
}

export function ExportButton() {
  const done = filmProgress.value;
  return (
    <Button
      class={css["export-button"]}
      popup="dialog"
      description={messages.saveAsFilmAnimation}
      disabled={!space.value}
      onClick={openFilm}
    >
      {done === null ? messages.exportLabel : messages.filmPercent(Math.floor(100 * done))}
    </Button>
  );
}

/** What else can be done with time. `all` also has what stands beside it where there is room. */
function TimeMenu({ all = false }: { all?: boolean }) {
  const line = timeline.value;
  const course = (to: "smooth" | "straight", label: string) => ({
    label,
    disabled: !line,
    ...(line?.course === to ? { icon: "check" as const } : {}),
    onSelect: () =>
      attempt(() => changeTimeline((now) => (now.course === to ? now : { ...now, course: to }))),
  });
  return (
    <div class={css["time-menu"]}>
      <Menu
        label={messages.moreOptionsForTime}
        items={[
          { label: messages.flyThrough, onSelect: () => fly("through") },
          { label: messages.flyAround, onSelect: () => fly("around") },
          course("smooth", messages.smoothAtKeyframes),
          course("straight", messages.straightBetweenKeyframes),
          { label: messages.halfSpeed, disabled: !line, onSelect: () => stretch(1.5) },
          { label: messages.doubleSpeed, disabled: !line, onSelect: () => stretch(0.5) },
          { label: messages.openSavedAnimation, onSelect: openAnimation },
          ...(all ? [{ label: messages.exportLabel, icon: "save" as const, onSelect: openFilm }] : []),
          { label: messages.removeAllKeyframes, icon: "bin", disabled: !line, onSelect: removeAllKeys },
        ]}
      />
    </div>
  );
}

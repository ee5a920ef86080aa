import { useEffect, useMemo, useRef } from "preact/hooks";
import { formatNumber } from "#format/numbers";
import { type Easing, MOST_HOLD } from "#geometry/pace";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { Repeat } from "#wasm/api";
import { secondsFor, usePreview } from "./estimate";
import css from "./film.module.css";
import { useFocusIfLost } from "./focus";
import { Ground } from "./Ground";
import { make } from "./job";
import * as messages from "./messages";
import { Picture } from "./Preview";
import {
  bytesWords,
  canBeClear,
  filmBytes,
  filmSeconds,
  frameCount,
  isFilm,
  isVideo,
  type Kind,
  LEAST_FPS,
  MOST_SECONDS,
  MOST_SIDE,
  mostFps,
  type Plan,
  planProblem,
  timeWords,
} from "./plan";
import { SeedField } from "./SeedField";
import { SizeFields } from "./SizeFields";
import {
  able,
  askAble,
  choose,
  chooseAll,
  chooseLength,
  chooseLoop,
  framesGo,
  hasEnds,
  loop,
  pick,
  plan,
  SIZES,
  subjects,
} from "./settings";
import type { FilmSubject, Numbers } from "./subject";

const QUALITIES = [
  { value: "small", label: messages.small },
  { value: "good", label: messages.good },
  { value: "best", label: messages.best },
] as const;

const ENDS: readonly { value: Repeat; label: string; description: string }[] = [
  { value: "once", label: messages.none, description: messages.stopsAtEnd },
  {
    value: "round",
    label: messages.restart,
    description: messages.startsAgainWithoutJump,
  },
  {
    value: "pingpong",
    label: messages.backAndForth,
    description: messages.playsInReverseFrom,
  },
];

const EASINGS: readonly { value: Easing; label: string; description: string }[] = [
  { value: "linear", label: messages.linear, description: messages.sameSpeedThroughout },
  {
    value: "ease",
    label: messages.easeInAndOut,
    description: messages.startsSlowlyAndSlows,
  },
];

const CHROMAS = [
  { value: "420", label: "4:2:0", description: messages.fourPixelsShareOne },
  { value: "444", label: "4:4:4", description: messages.everyPixelHasOwn },
] as const;

const SAMPLES: readonly { value: `${Plan["samples"]}`; label: string; description: string }[] = [
  { value: "1", label: "1", description: messages.jaggedEdgesFastest },
  { value: "4", label: "2 × 2", description: messages.smoothEdges },
  { value: "16", label: "4 × 4", description: messages.smoothestEdgesInAbout },
];

const DITHERS = [
  {
    value: "auto",
    label: messages.auto,
    description: messages.onlyWhereFilmHas,
  },
  { value: "on", label: messages.on, description: messages.mixesColoursWithDots },
  { value: "off", label: messages.off, description: messages.flatColoursSmallerFile },
] as const;

/** What is chosen of a subject, and the first frame beside it. */
export function Settings({ of: subject }: { of: FilmSubject }) {
  const button = useRef<HTMLButtonElement>(null);
  useFocusIfLost(button);
  const now = plan.value;
  const { width, height, fps } = now;
  // biome-ignore lint/correctness/useExhaustiveDependencies: what can be written depends on the size
  useEffect(() => void askAble(), [width, height, fps]);
  const preview = usePreview(isFilm(now.kind) ? subject : null, {
    ...now,
    clear: now.clear && canBeClear(now.kind),
    at: now.from,
  });
  const problem = planProblem(now, framesGo.value) ?? preview.problem;
  const film = isFilm(now.kind);
  return (
    <div class={css["export-sheet"]}>
      <div class={css["export-kinds"]}>
        <Subjects of={subject} />
        <Kinds numbers={subject.numbers} />
      </div>
      <div class={css["export-settings"]}>
        {film ? (
          <FilmFields of={now} subject={subject} />
        ) : (
          <NumbersFields of={now} numbers={subject.numbers} />
        )}
        {now.kind !== "keys" && !subject.anyLength && <Part of={now} seconds={subject.seconds} />}
      </div>
      {film && (
        <div class={css["export-preview"]}>
          <Picture image={preview.image} label={messages.firstFrame} ratio={width / height} />
        </div>
      )}
      {film && (
        <div class={css["export-look"]}>
          <LookFields of={now} subject={subject} />
        </div>
      )}
      <footer class={css["export-foot"]}>
        {problem === null ? (
          <Estimate of={now} subject={subject} go={framesGo.value} cost={preview.cost} lit={preview.lit} />
        ) : (
          <p class={css["export-problem"]} role="status">
            {problem}
          </p>
        )}
        <Button
          kind="primary"
          icon="save"
          buttonRef={button}
          disabled={problem !== null}
          onClick={() => void make(subject, now)}
        >
          {film ? messages.renderFilm : messages.save}
        </Button>
      </footer>
    </div>
  );
}

/** What there is to be filmed, where there is a choice. */
function Subjects({ of: subject }: { of: FilmSubject }) {
  if (subjects.value.length < 2) return null;
  return (
    <Segmented
      label={messages.film3}
      options={subjects.value.map(({ id, label }) => ({ value: id, label }))}
      value={subject.id}
      onChange={pick}
    />
  );
}

/** Only what the browser can write can be chosen; what it cannot is said. */
function Kinds({ numbers }: { numbers: Numbers | undefined }) {
  const { kind } = plan.value;
  const found = able.value;
  const none = typeof VideoEncoder === "undefined";
  const missing = found ? [...(found.mp4 ? [] : ["MP4"]), ...(found.webm ? [] : ["WebM"])] : [];
  const option = (value: Kind, label: string, description: string) => ({
    value,
    label,
    description,
    disabled: isVideo(value) && (none || (found !== null && !found[value])),
  });
  return (
    <>
      <Segmented<Kind>
        label={messages.format}
        options={[
          option("mp4", "MP4", messages.videoPlaysAlmostEverywhere),
          option("webm", "WebM", messages.videoForWebWith),
          option("gif", "GIF", messages.animationIn256Colours),
          option("apng", "APNG", messages.animationInFullColour),
          option("zip", messages.frames, messages.everyFrameAsPng),
          ...(numbers ? [option("frames", "JSON", messages.numbersParametersNotPixels)] : []),
        ]}
        value={kind === "keys" ? "frames" : kind}
        onChange={(next) => choose({ kind: next })}
      />
      {missing.length > 0 && (
        <p class="hint" role="status">
          {none ? messages.thisBrowserHasNo : messages.cannotWrite(missing.join(" or "))}
        </p>
      )}
    </>
  );
}

function FilmFields({ of, subject }: { of: Plan; subject: FilmSubject }) {
  const { width, height, fps, kind, quality, dither } = of;
  return (
    <>
      {subject.seeds && <SeedField of={subject.seeds} />}
      <SizeFields width={width} height={height} sizes={SIZES} most={MOST_SIDE} step={2} choose={choose}>
        <NumberField
          label={messages.framesPerSecond}
          value={fps}
          min={LEAST_FPS}
          max={mostFps(kind)}
          step={1}
          digits={2}
          onChange={(next) => choose({ fps: next })}
        />
        {subject.anyLength && (
          <NumberField
            label={messages.length}
            value={subject.seconds}
            min={0.5}
            max={MOST_SECONDS}
            step={0.5}
            digits={2}
            unit="s"
            onChange={chooseLength}
          />
        )}
      </SizeFields>
      {subject.loops.length > 1 && (
        <ChoiceRow
          label={messages.loop}
          options={ENDS.filter(({ value }) => subject.loops.includes(value))}
          value={loop.value}
          onChange={chooseLoop}
        />
      )}
      {hasEnds.value && subject.easing !== null && (
        <ChoiceRow
          label={messages.easing}
          options={EASINGS}
          value={of.easing}
          onChange={(next) => choose({ easing: next })}
        />
      )}
      {hasEnds.value && (
        <div class={css["export-pair"]}>
          <NumberField
            label={messages.pauseAtBothEnds}
            value={of.hold}
            min={0}
            max={MOST_HOLD}
            step={0.5}
            digits={2}
            unit="s"
            onChange={(next) => choose({ hold: next })}
          />
        </div>
      )}
      {isVideo(kind) && (
        <ChoiceRow
          label={messages.quality}
          options={QUALITIES}
          value={quality}
          onChange={(next) => choose({ quality: next })}
        />
      )}
      {isVideo(kind) && !(of.clear && canBeClear(kind)) && able.value?.fullColour && (
        <ChoiceRow
          label={messages.chroma}
          options={CHROMAS}
          value={of.fullColour ? "444" : "420"}
          onChange={(next) => choose({ fullColour: next === "444" })}
        />
      )}
      {of.fullColour && <p class="hint">{messages.playsInChromeEdge}</p>}
      {kind === "gif" && (
        <ChoiceRow
          label={messages.dither}
          options={DITHERS}
          value={dither === null ? "auto" : dither ? "on" : "off"}
          onChange={(next) => choose({ dither: next === "auto" ? null : next === "on" })}
        />
      )}
    </>
  );
}

/** How its frames look. */
function LookFields({ of, subject }: { of: Plan; subject: FilmSubject }) {
  const { kind, captions, inset } = of;
  return (
    <>
      <ChoiceRow
        label={messages.samplesPerPixel}
        options={subject.choosesSmooth ? SAMPLES : SAMPLES.slice(1)}
        value={`${of.samples}` as const}
        onChange={(next) => choose({ samples: Number(next) as Plan["samples"] })}
      />
      <Ground of={of} stage={subject.ground} canBeClear={canBeClear(kind)} choose={choose} />
      {subject.photograph !== undefined && (
        <Switch
          checked={of.photograph}
          description={messages.photosBothLeavesFade}
          onChange={(next) => choose({ photograph: next })}
        >
          {messages.withPhotos}
        </Switch>
      )}
      {subject.caption && (
        <Switch
          checked={captions}
          description={messages.inCornerEachFrame}
          onChange={(next) => choose({ captions: next })}
        >
          {messages.captionWithTimeAnd}
        </Switch>
      )}
      {subject.inset && (
        <Switch
          checked={inset}
          description={messages.locusWithPathSmall}
          onChange={(next) => choose({ inset: next })}
        >
          {messages.insetPositionOnLocus}
        </Switch>
      )}
    </>
  );
}

function NumbersFields({ of, numbers }: { of: Plan; numbers: Numbers | undefined }) {
  const { kind } = of;
  if (!numbers || isFilm(kind)) return null;
  return (
    <>
      <div class="row">
        <Segmented<Kind>
          label={messages.numbersToExport}
          options={numbers.kinds}
          value={kind}
          onChange={(next) => choose({ kind: next })}
        />
      </div>
      <p class="hint">{numbers.about[kind]}</p>
      {kind === "frames" && (
        <NumberField
          label={messages.framesPerSecond}
          value={of.fps}
          min={LEAST_FPS}
          max={mostFps(of.kind)}
          step={1}
          digits={2}
          onChange={(next) => choose({ fps: next })}
        />
      )}
    </>
  );
}

/** From when to when. */
function Part({ of, seconds }: { of: Plan; seconds: number }) {
  const all = of.from === 0 && of.to === seconds;
  return (
    <div class={`${css["export-pair"]} ${css["part"]}`}>
      {(["from", "to"] as const).map((end) => (
        <NumberField
          key={end}
          label={end === "from" ? messages.from : messages.to}
          value={of[end]}
          min={0}
          max={seconds}
          step={0.1}
          digits={2}
          unit="s"
          onChange={(next) => choose({ [end]: next })}
        />
      ))}
      <Button kind="quiet" disabled={all} onClick={chooseAll}>
        {messages.all}
      </Button>
    </div>
  );
}

interface EstimateProps {
  of: Plan;
  subject: FilmSubject;
  go: Repeat;
  cost: number | null;
  lit: number;
}

function Estimate({ of, subject, go, cost, lit }: EstimateProps) {
  const { numbers } = subject;
  const bytes = useMemo(
    () => (isFilm(of.kind) ? filmBytes(of, go, lit) : (numbers?.bytes(of, go) ?? null)),
    [of, go, lit, numbers],
  );
  if (of.kind === "keys") return <p class="hint">{messages.smallFile}</p>;
  const film = isFilm(of.kind);
  const count = frameCount(of, go);
  const end = ENDS.find(({ value }) => value === loop.value)?.label.toLowerCase();
  const frames = messages.framesAndLength(count, formatNumber(filmSeconds(of, go), 2));
  const parts = [
    go === "once" || end === undefined ? frames : messages.loopOf(frames, end),
    ...(bytes === null ? [] : [messages.aboutBytes(bytesWords(bytes))]),
    ...(!film && numbers && bytes !== null && bytes > numbers.mostBytes ? [messages.tooLargeToReopen] : []),
    ...(film && cost !== null ? [messages.aboutTime(timeWords(secondsFor(subject, of, go, cost)))] : []),
  ];
  return <p class="hint number">{parts.join(" · ")}</p>;
}

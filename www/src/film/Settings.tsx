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
import { Picture } from "./Preview";
import {
  bytesWords,
  canBeClear,
  filmBytes,
  filmSeconds,
  frameCount,
  grouped,
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
  { value: "small", label: "Small" },
  { value: "good", label: "Good" },
  { value: "best", label: "Best" },
] as const;

const ENDS: readonly { value: Repeat; label: string; description: string }[] = [
  { value: "once", label: "Once", description: "It stops at its end" },
  {
    value: "round",
    label: "Round",
    description: "It begins again without a jump, where it ends as it began",
  },
  {
    value: "pingpong",
    label: "To and fro",
    description: "It goes back the way it came: a loop without a jump",
  },
];

const EASINGS: readonly { value: Easing; label: string; description: string }[] = [
  { value: "linear", label: "Linear", description: "At the same speed all the way" },
  {
    value: "ease",
    label: "Ease in and out",
    description: "It starts gently, and slows down before it stops",
  },
];

const CHROMAS = [
  { value: "420", label: "4:2:0", description: "Four pixels share one colour: plays almost everywhere" },
  { value: "444", label: "4:4:4", description: "Every pixel has its own colour: crisp edges" },
] as const;

const SAMPLES: readonly { value: `${Plan["samples"]}`; label: string; description: string }[] = [
  { value: "1", label: "1", description: "Jagged edges, soon made" },
  { value: "4", label: "2 × 2", description: "Smooth edges" },
  { value: "16", label: "4 × 4", description: "The smoothest edges, in about four times the time" },
];

const DITHERS = [
  {
    value: "auto",
    label: "Auto",
    description: "Only where the film has more shades than 256 colours show well",
  },
  { value: "on", label: "On", description: "Mixes colours from dots: smoother shades, and a larger file" },
  { value: "off", label: "Off", description: "Flat colours, and a smaller file" },
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
          <Picture image={preview.image} label="The first frame" ratio={width / height} />
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
          {film ? "Make the film" : "Save"}
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
      label="What is filmed"
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
        label="Kind of file"
        options={[
          option("mp4", "MP4", "A video that plays almost everywhere"),
          option("webm", "WebM", "A video for the web, clear where it may be"),
          option("gif", "GIF", "A moving picture of 256 colours, for messages and old programs"),
          option("apng", "APNG", "A moving picture in all colours, clear where it may be"),
          option("zip", "Frames", "Every frame as a PNG, in one ZIP file"),
          ...(numbers ? [option("frames", "JSON", "Numbers: parameters, not pixels")] : []),
        ]}
        value={kind === "keys" ? "frames" : kind}
        onChange={(next) => choose({ kind: next })}
      />
      {missing.length > 0 && (
        <p class="hint" role="status">
          {none
            ? "This browser has no WebCodecs, so it cannot write videos. The other kinds stay."
            : `This browser cannot write ${missing.join(" or ")} at this size.`}
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
          label="Frames a second"
          value={fps}
          min={LEAST_FPS}
          max={mostFps(kind)}
          step={1}
          digits={2}
          onChange={(next) => choose({ fps: next })}
        />
        {subject.anyLength && (
          <NumberField
            label="Length"
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
          label="At the end"
          options={ENDS.filter(({ value }) => subject.loops.includes(value))}
          value={loop.value}
          onChange={chooseLoop}
        />
      )}
      {hasEnds.value && subject.easing !== null && (
        <ChoiceRow
          label="Easing"
          options={EASINGS}
          value={of.easing}
          onChange={(next) => choose({ easing: next })}
        />
      )}
      {hasEnds.value && (
        <div class={css["export-pair"]}>
          <NumberField
            label="Hold at ends"
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
          label="Quality"
          options={QUALITIES}
          value={quality}
          onChange={(next) => choose({ quality: next })}
        />
      )}
      {isVideo(kind) && !(of.clear && canBeClear(kind)) && able.value?.fullColour && (
        <ChoiceRow
          label="Chroma"
          options={CHROMAS}
          value={of.fullColour ? "444" : "420"}
          onChange={(next) => choose({ fullColour: next === "444" })}
        />
      )}
      {of.fullColour && (
        <p class="hint">Plays in Chrome, Edge, Firefox and VLC, but not in Safari or QuickTime.</p>
      )}
      {kind === "gif" && (
        <ChoiceRow
          label="Dithering"
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
        label="Samples per pixel"
        options={subject.choosesSmooth ? SAMPLES : SAMPLES.slice(1)}
        value={`${of.samples}` as const}
        onChange={(next) => choose({ samples: Number(next) as Plan["samples"] })}
      />
      <Ground of={of} stage={subject.ground} canBeClear={canBeClear(kind)} choose={choose} />
      {subject.photograph !== undefined && (
        <Switch
          checked={of.photograph}
          description="The photographs of both leaves fade from one into the other inside the outline"
          onChange={(next) => choose({ photograph: next })}
        >
          With the photographs
        </Switch>
      )}
      {subject.caption && (
        <Switch
          checked={captions}
          description="In the corner of each frame"
          onChange={(next) => choose({ captions: next })}
        >
          Say the moment, and whether it is in one piece
        </Switch>
      )}
      {subject.inset && (
        <Switch
          checked={inset}
          description="The map of parameters with the path, small, in a corner of each frame"
          onChange={(next) => choose({ inset: next })}
        >
          Show where on the map it is
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
          label="Which numbers"
          options={numbers.kinds}
          value={kind}
          onChange={(next) => choose({ kind: next })}
        />
      </div>
      <p class="hint">{numbers.about[kind]}</p>
      {kind === "frames" && (
        <NumberField
          label="Frames a second"
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
          label={end === "from" ? "From" : "to"}
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
        All of it
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
  if (of.kind === "keys") return <p class="hint">A small file.</p>;
  const film = isFilm(of.kind);
  const count = frameCount(of, go);
  const end = ENDS.find(({ value }) => value === loop.value)?.label.toLowerCase();
  const parts = [
    `${grouped(count)} ${count === 1 ? "frame" : "frames"}, ${formatNumber(filmSeconds(of, go), 2)} s${go === "once" ? "" : `, ${end}`}`,
    ...(bytes === null ? [] : [`about ${bytesWords(bytes)}`]),
    ...(!film && numbers && bytes !== null && bytes > numbers.mostBytes
      ? ["too large to be opened here again"]
      : []),
    ...(film && cost !== null
      ? [`about ${timeWords(secondsFor(subject, of, go, cost))} on this device`]
      : []),
  ];
  return <p class="hint number">{parts.join(" · ")}</p>;
}

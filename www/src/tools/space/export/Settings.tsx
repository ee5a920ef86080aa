import { useEffect, useMemo } from "preact/hooks";
import { timeline } from "#document/space/space";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { Select } from "#ui/controls/Select";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { Repeat } from "#wasm/api";
import { MOST_BYTES } from "../time/saved/saved";
import { loopOf, secondsWords } from "../time/words";
import { parametersBytes, secondsFor, usePreview } from "./estimate";
import css from "./export.module.css";
import { make } from "./job";
import { Picture } from "./Picture";
import {
  bytesWords,
  filmBytes,
  filmSeconds,
  frameCount,
  grouped,
  isFilm,
  type Kind,
  LEAST_FPS,
  LEAST_SIDE,
  MOST_SIDE,
  mostFps,
  type Plan,
  planProblem,
  timeWords,
} from "./plan";
import { able, askAble, choose, chooseAll, framesGo, loop, plan, SIZES } from "./settings";

const JSON_KINDS = [
  {
    value: "frames",
    label: "Every frame",
    description: "The parameters of each frame, for other programs and for Frond",
  },
  { value: "keys", label: "Shapes and keys", description: "A small file for Frond" },
] as const;

const QUALITIES = [
  { value: "small", label: "Small" },
  { value: "good", label: "Good" },
  { value: "best", label: "Best" },
] as const;

export function Settings() {
  const now = plan.value;
  const { width, height, fps } = now;
  // biome-ignore lint/correctness/useExhaustiveDependencies: what can be written depends on the size
  useEffect(() => void askAble(), [width, height, fps]);
  const preview = usePreview(now);
  const problem = planProblem(now, framesGo.value) ?? preview.problem;
  const film = isFilm(now.kind);
  return (
    <div class={css["export-sheet"]}>
      <Kinds />
      <div class={css["export-settings"]}>
        {film ? <FilmFields of={now} /> : <NumbersFields of={now} />}
        {now.kind !== "keys" && <Part of={now} />}
      </div>
      {film && (
        <div class={css["export-preview"]}>
          <Picture image={preview.image} label="The first frame" ratio={width / height} />
        </div>
      )}
      <footer class={css["export-foot"]}>
        {problem === null ? (
          <Estimate of={now} go={framesGo.value} cost={preview.cost} lit={preview.lit} />
        ) : (
          <p class={css["export-problem"]} role="status">
            {problem}
          </p>
        )}
        <Button kind="primary" icon="save" disabled={problem !== null} onClick={() => void make(now)}>
          {film ? "Make the film" : "Save"}
        </Button>
      </footer>
    </div>
  );
}

/** Only what the browser can write can be chosen; what it cannot is said. */
function Kinds() {
  const { kind } = plan.value;
  const found = able.value;
  const none = typeof VideoEncoder === "undefined";
  const missing = found
    ? ([found.mp4 ? null : "MP4", found.webm ? null : "WebM"].filter(Boolean) as string[])
    : [];
  const option = (value: Kind, label: string, description: string) => ({
    value: value === "keys" ? ("frames" as Kind) : value,
    label,
    description,
    disabled: (value === "mp4" || value === "webm") && (none || (found !== null && found[value] === null)),
  });
  return (
    <div class={css["export-kinds"]}>
      <Segmented<Kind>
        label="Kind of file"
        options={[
          option("mp4", "MP4", "A video that plays almost everywhere"),
          option("webm", "WebM", "A video for the web"),
          option("gif", "GIF", "A moving picture of 256 colours"),
          option("frames", "JSON", "Numbers: parameters, not pixels"),
        ]}
        value={kind === "keys" ? "frames" : kind}
        onChange={(next) => choose({ kind: next })}
      />
      {missing.length > 0 && (
        <p class="hint" role="status">
          {none
            ? "This browser has no WebCodecs, so it cannot write videos. GIF and JSON stay."
            : `This browser cannot write ${missing.join(" or ")} at this size.`}
        </p>
      )}
    </div>
  );
}

function FilmFields({ of }: { of: Plan }) {
  const { width, height, fps, kind, quality, smooth } = of;
  const size = SIZES.find((one) => one.width === width && one.height === height);
  return (
    <>
      <label class={css["export-size"]}>
        <span class="field-label">Size</span>
        <Select
          value={size?.id ?? "own"}
          onChange={(event) => {
            const next = SIZES.find((one) => one.id === event.currentTarget.value);
            if (next) choose({ width: next.width, height: next.height });
          }}
        >
          {SIZES.map(({ id, name }) => (
            <option key={id} value={id}>
              {name}
            </option>
          ))}
          {!size && <option value="own">Your own</option>}
        </Select>
      </label>
      <div class={css["export-pair"]}>
        {(["width", "height"] as const).map((side) => (
          <NumberField
            key={side}
            label={side === "width" ? "Width" : "Height"}
            value={side === "width" ? width : height}
            min={LEAST_SIDE}
            max={MOST_SIDE}
            step={2}
            digits={0}
            onChange={(next) => choose({ [side]: next })}
          />
        ))}
      </div>
      <NumberField
        label="Frames a second"
        value={fps}
        min={LEAST_FPS}
        max={mostFps(kind)}
        step={1}
        digits={2}
        onChange={(next) => choose({ fps: next })}
      />
      {kind !== "gif" && (
        <ChoiceRow
          label="Quality"
          options={QUALITIES}
          value={quality}
          onChange={(next) => choose({ quality: next })}
        />
      )}
      <Switch
        checked={smooth}
        description="Four pixels are carved for each one"
        onChange={(next) => choose({ smooth: next })}
      >
        Smooth edges, in about four times the time
      </Switch>
    </>
  );
}

function NumbersFields({ of }: { of: Plan }) {
  return (
    <>
      <div class="row">
        <Segmented<Kind>
          label="Which numbers"
          options={JSON_KINDS}
          value={of.kind}
          onChange={(next) => choose({ kind: next })}
        />
      </div>
      <p class="hint">
        {of.kind === "keys"
          ? "The shapes, the light and the keys as they are here. Frond opens it again: More of time, Open a saved animation."
          : "For each frame its time, the view, and the parameters of every object: 12 numbers a map, the rows of its matrix and then its translation. Frond opens it again, with its keys."}
      </p>
      {of.kind === "frames" && (
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
function Part({ of }: { of: Plan }) {
  const seconds = timeline.value?.seconds ?? 0;
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
  go: Repeat;
  cost: number | null;
  lit: number;
}

function Estimate({ of, go, cost, lit }: EstimateProps) {
  const bytes = useMemo(() => {
    if (isFilm(of.kind)) return filmBytes(of, go, lit);
    return of.kind === "frames" ? parametersBytes(of, go) : null;
  }, [of, go, lit]);
  if (of.kind === "keys") return <p class="hint">A small file.</p>;
  const count = frameCount(of, go);
  const parts = [
    `${grouped(count)} ${count === 1 ? "frame" : "frames"}, ${secondsWords(filmSeconds(of, go))}${go === "once" ? "" : `, ${loopOf(loop.value)?.label.toLowerCase()}`}`,
    ...(bytes === null ? [] : [`about ${bytesWords(bytes)}`]),
    ...(!isFilm(of.kind) && bytes !== null && bytes > MOST_BYTES
      ? ["too large to be opened here again"]
      : []),
    ...(isFilm(of.kind) && cost !== null
      ? [`about ${timeWords(secondsFor(of, go, cost))} on this device`]
      : []),
  ];
  return <p class="hint number">{parts.join(" · ")}</p>;
}

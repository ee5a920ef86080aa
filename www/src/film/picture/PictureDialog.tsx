import { signal, useComputed } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { notify, wordsOf } from "#document/notice";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { Switch } from "#ui/controls/Switch";
import { download } from "#ui/files/download";
import { Dialog } from "#ui/overlay/Dialog";
import "#ui/panel/progress.css";
import { makePicture } from "#workers/film/picture";
import { usePreview } from "../estimate";
import css from "../film.module.css";
import { Ground } from "../Ground";
import * as messages from "../messages";
import { exportOpen } from "../open";
import { Picture } from "../Preview";
import { LEAST_SIDE } from "../plan";
import { SeedField } from "../SeedField";
import { type NamedSize, SizeFields } from "../SizeFields";
import { begun } from "../settings";
import type { Still } from "../subject";
import { MOST_PICTURE_SIDE, type PicturePlan, pictureProblem, pictureWords } from "./plan";

const LONG_SIDE = 2400;
/** Fewer cores would be at it for long. */
const MANY_CORES = 8;

/** What was chosen last stays for the visit; no size: that of the stage, larger. */
const chosen = signal<Omit<PicturePlan, "width" | "height"> & { width?: number; height?: number }>({
  ground: null,
  clear: true,
  link: true,
  smooth: navigator.hardwareConcurrency >= MANY_CORES,
});
/** How many steps of a shape in the making; null: what is on the stage. */
const step = signal<number | null>(null);
const FIRST_STEP = 3;
/** How far the picture is that is being made, 0 to 1, and how to end it. */
const running = signal<{ done: number; stop: AbortController } | null>(null);

const close = () => {
  running.peek()?.stop.abort();
  exportOpen.value = null;
};

/**
 * The picture on the stage, or a shape in the making, as a PNG of any size. `link` is the address of the document,
 * where there is one.
 */
export function PictureDialog({ still, link }: { still: () => Promise<Still>; link: () => string | null }) {
  const [found, setFound] = useState<Still | { problem: string } | null>(null);
  useEffect(() => {
    still().then(setFound, (problem) => setFound({ problem: wordsOf(problem) }));
  }, [still]);
  return (
    <Dialog title={messages.savePicture} about={messages.drawnAgainAtThis} onClose={close} wide>
      {!found ? (
        <p class={css["export-nothing"]}>{messages.preparing}</p>
      ) : "problem" in found ? (
        <p class={css["export-problem"]}>{found.problem}</p>
      ) : (
        <Choices still={found} link={link} />
      )}
    </Dialog>
  );
}

function Choices({ still, link }: { still: Still; link: () => string | null }) {
  const { stage, steps } = still;
  const making = useComputed(() => (steps ? begun(steps) : null)).value;
  const most = (making?.seconds ?? 1) - 1;
  const drawn: Drawn =
    making && step.value !== null
      ? { subject: making, at: Math.min(step.value, most), inStrips: false, steps: true }
      : { ...still, steps: false };
  const { subject, at, inStrips } = drawn;
  const plan = planOf(stage);
  const { width, height } = plan;
  const preview = usePreview(subject, { ...plan, at });
  const problem = pictureProblem(plan, inStrips) ?? preview.problem;
  const now = running.value;
  return (
    <div class={css["export-sheet"]}>
      {making && (
        <div class={css["export-kinds"]}>
          <Segmented
            label={messages.picture}
            options={WHAT}
            value={drawn.steps ? "steps" : "stage"}
            onChange={(next) => {
              step.value = next === "steps" ? FIRST_STEP : null;
            }}
          />
        </div>
      )}
      <div class={css["export-settings"]}>
        {drawn.steps && (
          <>
            {making?.seeds && <SeedField of={making.seeds} />}
            <NumberField
              label={messages.steps}
              value={at}
              min={0}
              max={most}
              whole
              onChange={(next) => {
                step.value = next;
              }}
            />
          </>
        )}
        <SizeFields
          width={width}
          height={height}
          sizes={SIZES}
          first={{
            name: messages.asOnStageLarger,
            chosen: chosen.value.width === undefined,
            choose: () => {
              const { width: _width, height: _height, ...rest } = chosen.peek();
              chosen.value = rest;
            },
          }}
          most={MOST_PICTURE_SIDE}
          step={1}
          choose={(size) => change({ width, height, ...size })}
        />
        <Ground of={plan} stage={subject.ground} canBeClear choose={change} />
        {subject.choosesSmooth && (
          <Switch checked={plan.smooth} onChange={(smooth) => change({ smooth })}>
            {messages.smoothEdgesInAbout}
          </Switch>
        )}
        <Switch
          checked={plan.link}
          description={messages.ifYouOpenPicture}
          onChange={(next) => change({ link: next })}
        >
          {messages.includeLinkInPicture}
        </Switch>
      </div>
      <div class={css["export-preview"]}>
        <Picture image={preview.image} label={messages.picture2} ratio={width / height} />
      </div>
      <footer class={css["export-foot"]}>
        {now ? (
          <progress
            class="progress"
            max={1}
            {...(inStrips ? { value: now.done } : {})}
            aria-label={messages.progressPicture}
          />
        ) : problem === null ? (
          <p class="hint number">{pictureWords(plan, preview.lit)}</p>
        ) : (
          <p class={css["export-problem"]} role="status">
            {problem}
          </p>
        )}
        {now ? (
          <Button onClick={() => now.stop.abort()}>{messages.cancel}</Button>
        ) : (
          <Button
            kind="primary"
            icon="save"
            disabled={problem !== null}
            onClick={() => void save(drawn, plan, plan.link ? link() : null)}
          >
            {messages.saveAsPng}
          </Button>
        )}
      </footer>
    </div>
  );
}

/** The size of the stage, larger; or what was chosen. */
function planOf(stage: Still["stage"]): PicturePlan {
  const larger = LONG_SIDE / Math.max(stage.width, stage.height, 1);
  const { width, height, ...rest } = chosen.value;
  return {
    ...rest,
    width: width ?? Math.max(LEAST_SIDE, Math.round(stage.width * larger)),
    height: height ?? Math.max(LEAST_SIDE, Math.round(stage.height * larger)),
  };
}

function change(part: Partial<PicturePlan>): void {
  chosen.value = { ...chosen.peek(), ...part };
}

/** What becomes the picture; `steps`: a shape in the making, `at` as many steps. */
type Drawn = Pick<Still, "subject" | "at" | "inStrips"> & { steps: boolean };

const WHAT = [
  { value: "stage", label: messages.asOnStage },
  { value: "steps", label: messages.stepByStep },
] as const;

const SIZES: readonly NamedSize[] = [
  { id: "full", name: messages.fullHd19201080, width: 1920, height: 1080 },
  { id: "4k", name: "4K, 3840 × 2160", width: 3840, height: 2160 },
  { id: "square", name: messages.square20482048, width: 2048, height: 2048 },
  { id: "poster", name: messages.poster57938192, width: 5793, height: 8192 },
  { id: "largest", name: messages.largest81928192, width: 8192, height: 8192 },
];

async function save({ subject, at, steps }: Drawn, plan: PicturePlan, link: string | null): Promise<void> {
  const stop = new AbortController();
  running.value = { done: 0, stop };
  const { width, height, smooth } = plan;
  const ground = plan.clear ? null : (plan.ground ?? subject.ground);
  try {
    const { bytes, type } = await makePicture(
      { subject, at, smooth, settings: { width, height, ground, link } },
      stop.signal,
      (done) => {
        running.value = { done, stop };
      },
    );
    download(new Blob([bytes], { type }), `frond-${subject.name}${steps ? `-${at}` : ""}.png`);
    exportOpen.value = null;
  } catch (problem) {
    if (!stop.signal.aborted) {
      notify({ kind: "error", text: messages.pictureFailed(wordsOf(problem)) });
    }
  } finally {
    running.value = null;
  }
}

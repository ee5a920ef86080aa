import "#ui/panel/progress.css";
import { signal } from "@preact/signals";
import { useEffect, useState } from "preact/hooks";
import { notify, wordsOf } from "#document/notice";
import { space } from "#document/space/space";
import { exportOpen } from "#film/open";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { type Option, Segmented } from "#ui/controls/Segmented";
import { download, plainName } from "#ui/files/download";
import { Dialog } from "#ui/overlay/Dialog";
import type { MeshFormat } from "#wasm/api";
import { solid } from "#wasm/space";
import { spaceTask } from "#workers/space/client";
import type { Shown } from "#workers/space/complete-picture";
import type { MeshMeasured } from "#workers/space/mesh";
import * as messages from "../messages";
import { colours, sight } from "../stage/sight";
import css from "./mesh.module.css";
import {
  adviceOf,
  type Foretold,
  foretell,
  LEAST_FINENESS,
  type MeshPlan,
  MOST_FINENESS,
  measuredAt,
  meshProblem,
  meshWords,
} from "./plan";

/** The lane that neither the stage nor what is short waits for. */
const LONG_WORK = 3;
const SHORT_WORK = 2;
/** So long after the last change it is measured, in milliseconds. */
const REST_MS = 250;

/** What was chosen last stays for the visit. */
const plan = signal<MeshPlan>({ format: "stl", fineness: 128, size: 100, wall: 2 });
/** The part of the mesh that is made, and how to end it. */
const running = signal<{ done: number; stop: AbortController } | null>(null);

const FORMATS: readonly Option<MeshFormat>[] = [
  { value: "stl", label: "STL", description: messages.for3DPrinters },
  { value: "ply", label: "PLY", description: messages.withColoursAndNormals },
  {
    value: "glb",
    label: "glTF",
    description: messages.forPagesAndScenes,
  },
];
const TYPES: Record<MeshFormat, string> = {
  stl: "model/stl",
  ply: "application/octet-stream",
  glb: "model/gltf-binary",
};

const close = () => {
  running.peek()?.stop.abort();
  exportOpen.value = null;
};

/** The bodies on the stage, as they are at this moment, as one watertight mesh. */
export function MeshDialog() {
  const [objects] = useState(() => sight.peek()?.objects ?? null);
  return (
    <Dialog title={messages.meshFor3D} about={messages.stageAtThisMoment} onClose={close}>
      {objects ? <Choices objects={objects} /> : <p class="hint">{messages.thereNothingToExport}</p>}
    </Dialog>
  );
}

function Choices({ objects }: { objects: Shown[] }) {
  const { format, fineness, size, wall } = plan.value;
  const { foretold, problem: failed } = useForetold(objects, plan.value);
  const problem = failed ?? meshProblem(plan.value, foretold);
  const now = running.value;
  return (
    <div class={css["mesh-sheet"]}>
      <Segmented
        label={messages.format}
        value={format}
        options={FORMATS}
        onChange={(next) => change({ format: next })}
      />
      <p class="hint">{FORMATS.find(({ value }) => value === format)?.description}.</p>
      <div class={css["mesh-measures"]}>
        <NumberField
          label={messages.longestSide}
          unit="mm"
          value={size}
          min={1}
          max={10_000}
          step={1}
          digits={2}
          onChange={(next) => change({ size: next })}
        />
        <NumberField
          label={messages.thinnestWall}
          unit="mm"
          value={wall}
          min={0}
          max={1000}
          step={0.1}
          digits={2}
          onChange={(next) => change({ wall: next })}
        />
        <NumberField
          label={messages.resolution}
          value={fineness}
          min={LEAST_FINENESS}
          max={MOST_FINENESS}
          whole
          step={16}
          onChange={(next) => change({ fineness: Math.round(next) })}
        />
      </div>
      <p class="hint">{messages.resolutionNumberSamplesAlong}</p>
      <div class={css["mesh-told"]} role="status">
        {problem === null ? (
          <>
            <p class="number">
              {foretold ? meshWords(foretold, bytesOf(format, foretold)) : messages.measuring}
            </p>
            {foretold &&
              adviceOf(plan.value, foretold).map((words) => (
                <p key={words} class="hint">
                  {words}
                </p>
              ))}
          </>
        ) : (
          <p class={css["mesh-problem"]}>{problem}</p>
        )}
      </div>
      <footer class={css["mesh-foot"]}>
        {now && <progress class="progress" max={1} value={now.done} aria-label={messages.progressMesh} />}
        {now ? (
          <Button onClick={() => now.stop.abort()}>{messages.cancel}</Button>
        ) : (
          <Button
            kind="primary"
            icon="save"
            disabled={problem !== null || !foretold}
            onClick={() => foretold && void save(objects, plan.peek(), foretold)}
          >
            {messages.saveMesh}
          </Button>
        )}
      </footer>
    </div>
  );
}

function change(part: Partial<MeshPlan>): void {
  plan.value = { ...plan.peek(), ...part };
}

const bytesOf = (format: MeshFormat, { triangles }: Foretold) => solid.meshBytes(format, triangles);

/** What the mesh will be, once that is measured. */
function useForetold(objects: Shown[], { fineness, size, wall }: MeshPlan) {
  const [found, setFound] = useState<{ foretold: Foretold | null; problem: string | null }>({
    foretold: null,
    problem: null,
  });
  useEffect(() => {
    const stop = new AbortController();
    setFound({ foretold: null, problem: null });
    const measure = async () => {
      const measured: { fineness: number; facts: MeshMeasured }[] = [];
      try {
        for (const at of measuredAt(fineness)) {
          const options = { fineness: at, size, wall };
          const how = { signal: stop.signal, lane: SHORT_WORK } as const;
          measured.push({ fineness: at, facts: await spaceTask("meshFacts", { objects, options }, how) });
        }
        setFound({ foretold: foretell(fineness, measured), problem: null });
      } catch (problem) {
        if (!stop.signal.aborted) setFound({ foretold: null, problem: wordsOf(problem) });
      }
    };
    const rest = setTimeout(() => void measure(), REST_MS);
    return () => {
      clearTimeout(rest);
      stop.abort();
    };
  }, [objects, fineness, size, wall]);
  return found;
}

/** Where the points are found, this much is done; then comes the surface. */
const POINTS_PART = 0.7;

async function save(objects: Shown[], { format, ...options }: MeshPlan, { found }: Foretold): Promise<void> {
  const stop = new AbortController();
  running.value = { done: 0, stop };
  try {
    const { bytes } = await spaceTask(
      "meshFile",
      { objects, options, format, palette: colours.peek() },
      {
        signal: stop.signal,
        lane: LONG_WORK,
        onProgress: (points) => {
          running.value = { done: POINTS_PART * Math.min(1, points / Math.max(1, found)), stop };
        },
      },
    );
    download(new Blob([bytes], { type: TYPES[format] }), `frond-${nameOf()}.${format}`);
    exportOpen.value = null;
  } catch (problem) {
    if (!stop.signal.aborted) {
      notify({ kind: "error", text: messages.meshNotSaved(wordsOf(problem)) });
    }
  } finally {
    running.value = null;
  }
}

function nameOf(): string {
  const objects = space.peek()?.objects ?? [];
  return plainName(objects.length === 1 ? (objects[0]?.name ?? "") : "", "space");
}

import { computed, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { BOUNDS } from "#compute/locus/job";
import { pause, setT } from "#document/playback";
import { scene } from "#document/scene";
import type { Uv } from "#geometry/path";
import { Field } from "#stage/locus/Field";
import { HomeTicks } from "#stage/locus/HomeTicks";
import { Legend } from "#stage/locus/Legend";
import { LocusHead, statesIn } from "#stage/locus/LocusHead";
import { LocusProgress } from "#stage/locus/LocusProgress";
import locusCss from "#stage/locus/locus.module.css";
import type { LocusStyle } from "#stage/locus/paint";
import "#stage/locus/handles.css";
import { EPSILON } from "#workers/lanes/locus-fill";
import * as messages from "../messages";
import { momentNear, place } from "./place";
import { field, inSight, problem, watchLocus } from "./work";

/** How it is shown: a way of looking, no part of the document. */
const style = signal<LocusStyle>("gap");
const locus = computed(() => field.value?.locus ?? null);
const states = statesIn(locus);
const coarse = computed(() => locus.value?.progress === 1 && locus.value.stride > 1);
const LABEL = messages.locusOverUTo + messages.pathRunsStraightFrom;

/** Where the morph of two graph-directed shapes holds together, with the straight way through it. */
export function DirectedMap() {
  const section = useRef<HTMLElement>(null);
  useEffect(() => {
    const observer = new IntersectionObserver((entries) => {
      inSight.value = entries.at(-1)?.isIntersecting === true;
    });
    if (section.current) observer.observe(section.current);
    const stop = watchLocus();
    return () => {
      observer.disconnect();
      stop();
      inSight.value = false;
    };
  }, []);
  return (
    <section class="locus" ref={section} aria-labelledby="directed-locus">
      <LocusHead id="directed-locus" style={style} />
      <div class={locusCss["locus-plot"]}>
        <HomeTicks axis="v" />
        <Square />
        <HomeTicks axis="u" />
      </div>
      <Legend states={states.value} epsilon={EPSILON} style={style.value} />
      {coarse.value && <p class="hint">{messages.locusCoarseBecauseEach}</p>}
    </section>
  );
}

function Square() {
  const square = useRef<HTMLDivElement>(null);
  const now = locus.value;
  const go = ({ clientX, clientY }: PointerEvent) => {
    const box = square.current?.getBoundingClientRect();
    if (!box || box.width === 0) return;
    pause();
    setT(momentNear([(clientX - box.left) / box.width, (clientY - box.top) / box.height]));
  };
  return (
    <div
      class="locus-square"
      ref={square}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        go(event);
      }}
      onPointerMove={(event) => {
        if (event.currentTarget.hasPointerCapture(event.pointerId)) go(event);
      }}
    >
      <div class="locus-plane" role="img" aria-label={LABEL}>
        <Field
          samples={now && { ...now, bounds: BOUNDS, epsilon: EPSILON }}
          frame={BOUNDS}
          style={style.value}
        />
      </div>
      <Way />
      <Mark at={[0, 0]} letter="A" />
      <Mark at={[1, 1]} letter="B" />
      <Now />
      {problem.value === null ? (
        <LocusProgress share={now?.progress ?? 0} />
      ) : (
        <p class="locus-problem" role="status">
          {problem.value}
        </p>
      )}
    </div>
  );
}

const percent = (at: Uv) => {
  const [x, y] = place(at);
  return { left: `${100 * x}%`, top: `${100 * y}%` };
};

function Way() {
  const [[x0, y0], [x1, y1]] = [place([0, 0]), place([1, 1])];
  const d = `M${100 * x0} ${100 * y0}L${100 * x1} ${100 * y1}`;
  return (
    <svg class="locus-path" viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
      <path class="path-casing" d={d} />
      <path class="path-core" d={d} />
    </svg>
  );
}

function Mark({ at, letter }: { at: Uv; letter: string }) {
  return (
    <span class="locus-end" style={percent(at)} aria-hidden="true">
      {letter}
    </span>
  );
}

/** The moment that is seen. */
function Now() {
  const { t } = scene.value;
  const end = t === 0 || t === 1 ? "at-end" : "";
  return <span class={`handle current ${end}`} style={percent([t, t])} aria-hidden="true" />;
}

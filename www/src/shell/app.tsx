import { type Signal, signal, useSignalEffect } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { type CurveParts, curved } from "#document/curve/curve";
import { tool } from "#document/deform/bend";
import { route } from "#document/link";
import { announcement, dismiss, notices, notify, wordsOf } from "#document/notice";
import { evidenceOpen } from "#stage/marks";
import { Stage } from "#stage/stage";
import type { PainterBackend } from "#stage/surface/painter";
import { MorphPanel, MorphStrip } from "#tools/morph/index";
import { lazily } from "#ui/lazy";
import { Toasts } from "#ui/Toasts";
import type { Tool } from "#wasm/api";
import { curvesFetched, loadCurves } from "#wasm/curve";
import { Header } from "./header";
import { Readout, VerdictChip } from "./readouts";

/** The whole page. */
export function App({ backend }: { backend: "auto" | PainterBackend }) {
  const at = route.value;
  useSignalEffect(() => {
    document.title = route.value.page === "figures" ? "Figures · Frond" : "Frond";
  });
  return (
    <>
      <Header />
      {at.page === "studio" ? <Studio backend={backend} /> : <FiguresPage figure={at.figure} />}
      <Notices />
    </>
  );
}

/** What is said, on screen and aloud. */
function Notices() {
  return (
    <>
      <div class="notices">
        <Toasts toasts={notices.value} onDismiss={dismiss} />
      </div>
      <p class="unseen" role="status" aria-live="polite">
        {announcement.value}
      </p>
    </>
  );
}

/** What is told and shown of each tool. */
const TOOLS: Record<Tool, { title: string; side: string; missing: string }> = {
  morph: { title: "Frond: morph one fractal into another", side: "Shapes and path", missing: "" },
  deform: {
    title: "Frond: bend a fractal by a grid",
    side: "Shape and grid",
    missing: "The deformation grid could not be loaded",
  },
  fit: {
    title: "Frond: find the formula of an outline",
    side: "Outline and fit",
    missing: "The fit could not be loaded",
  },
  space: {
    title: "Frond: turn and move fractals in space",
    side: "Shapes, morph and light",
    missing: "Space could not be loaded",
  },
};

/** The tools share the stage; each brings its own panel and its own time strip. */
function Studio({ backend }: { backend: "auto" | PainterBackend }) {
  const now = tool.value;
  useSignalEffect(() => {
    if (tool.value === "deform") load(deform, () => import("#tools/deform/index"), tool.value);
    if (tool.value === "fit") load(fit, () => withCurves(import("#tools/fit/index")), tool.value);
    if (tool.value === "space") load(space, openSpace, tool.value);
  });
  const [Deform, Fit, Space] = [deform.value, fit.value, space.value];
  const { title, side } = TOOLS[now];
  return (
    <main class="studio">
      <h1 class="unseen">{title}</h1>
      {/* It keeps its renderer while a tool with a picture of its own is open. */}
      <div class={now === "fit" || now === "space" ? "stage-away" : "stage-here"}>
        <Stage
          backend={backend}
          overlay={now === "deform" ? Deform !== null && <Deform.DeformOverlay /> : undefined}
        >
          <div class="stage-foot">
            {now === "morph" && (curved.value ? <CurveChip /> : <VerdictChip />)}
            <Readout />
          </div>
          {now === "morph" && (curved.value ? <CurveEvidence /> : evidenceOpen.value && <EvidencePanel />)}
        </Stage>
      </div>
      {now === "fit" && (
        <section class="stage" aria-label="Outline">
          {Fit && <Fit.FitStage />}
        </section>
      )}
      {now === "space" && (
        <section class="stage" aria-label="Space">
          {Space && <Space.SpaceStage backend={backend} />}
        </section>
      )}
      <aside class="side" aria-label={side}>
        {now === "morph" && <MorphPanel curve={CURVE} />}
        {now === "deform" && Deform && <Deform.DeformPanel curve={CURVE} />}
        {now === "fit" && Fit && <Fit.FitPanel />}
        {now === "space" && Space && <Space.SpacePanel />}
      </aside>
      <div class="time">
        {now === "morph" && <MorphStrip />}
        {now === "deform" && Deform && <Deform.DeformStrip />}
        {now === "fit" && Fit && <Fit.FitStrip />}
        {now === "space" && Space && <Space.SpaceStrip />}
      </div>
    </main>
  );
}

/** What is shown of closed curves is loaded when there are some, or when one may be chosen. */
const CurveChip = lazily(() => withCurves(import("#curve/index")).then((module) => module.CurveChip));
const CurveEvidence = lazily(() => withCurves(import("#curve/index")).then((module) => module.CurveEvidence));
const CURVE: CurveParts = {
  Panel: lazily(() => withCurves(import("#curve/index")).then((module) => module.CurvePanel)),
  Shelf: lazily(() => withCurves(import("#curve/index")).then((module) => module.Shelf)),
};

/** What is known of the picture is loaded when somebody asks. */
const evidence = () => import("#tools/morph/evidence/Panel").then((module) => module.EvidencePanel);
const EvidencePanel = lazily(evidence);

/** Fetches evidence, and what the gallery shows of curves, so that they are there without a network, too. */
export function fetchAhead(): void {
  const tried = () => {
    curvesFetched.value = true;
  };
  Promise.all([withCurves(import("#curve/index")), evidence()]).then(tried, tried);
}

/** A part of the page, with what makes closed curves and graphs. */
async function withCurves<T>(part: Promise<T>): Promise<T> {
  const [module] = await Promise.all([part, loadCurves()]);
  return module;
}

const deform = signal<typeof import("#tools/deform/index") | null>(null);
const fit = signal<typeof import("#tools/fit/index") | null>(null);
const space = signal<typeof import("#tools/space/index") | null>(null);

/** Space, with what computes it. */
async function openSpace() {
  const module = await import("#tools/space/index");
  await module.openSpace();
  return module;
}

/** Tools besides the morph are loaded when they are first opened. */
function load<T>(into: Signal<T | null>, get: () => Promise<T>, name: Tool): void {
  if (into.peek()) return;
  get().then(
    (module) => {
      into.value = module;
    },
    (problem) => notify({ kind: "error", text: `${TOOLS[name].missing}: ${wordsOf(problem)}` }),
  );
}

type FiguresComponent = ComponentType<{ figure: string | null }>;
const figures = signal<FiguresComponent | null>(null);

/** The figures are loaded when they are first asked for. */
function FiguresPage({ figure }: { figure: string | null }) {
  useEffect(() => {
    if (figures.peek()) return;
    import("#figures/index").then(
      (module) => {
        figures.value = module.Figures;
      },
      (problem) => notify({ kind: "error", text: `The figures could not be loaded: ${wordsOf(problem)}` }),
    );
  }, []);
  const Figures = figures.value;
  return <main class="figures-page">{Figures ? <Figures figure={figure} /> : null}</main>;
}

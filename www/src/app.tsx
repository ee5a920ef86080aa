import { signal, useSignalEffect } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import type { PainterBackend } from "./canvas/painter";
import { Stage } from "./canvas/stage";
import { loadProof } from "./engine/proof";
import { EvidencePanel } from "./shell/evidence/Panel";
import { Header } from "./shell/header";
import { Readout, VerdictChip } from "./shell/readouts";
import { tool } from "./state/bend";
import { type CurveParts, curved } from "./state/curve";
import { route } from "./state/link";
import { announcement, dismiss, notices, notify, wordsOf } from "./state/notice";
import { lazily } from "./ui/lazy";
import { Toasts } from "./ui/Toasts";
import { MorphPanel, MorphStrip } from "./views/morph";

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

/** The tools share the stage; each brings its own panel and its own time strip. */
function Studio({ backend }: { backend: "auto" | PainterBackend }) {
  const bending = tool.value === "deform";
  useEffect(() => {
    if (bending) loadDeform();
  }, [bending]);
  const Deform = deform.value;
  return (
    <main class="studio">
      <h1 class="unseen">
        {bending ? "Frond: bend a fractal by a grid" : "Frond: morph one fractal into another"}
      </h1>
      <Stage backend={backend} overlay={bending ? Deform !== null && <Deform.DeformOverlay /> : undefined}>
        <div class="stage-foot">
          {!bending && (curved.value ? <CurveChip /> : <VerdictChip />)}
          <Readout />
        </div>
        {!bending && (curved.value ? <CurveEvidence /> : <EvidencePanel />)}
      </Stage>
      <aside class="side" aria-label={bending ? "Shape and grid" : "Shapes and path"}>
        {bending ? Deform && <Deform.DeformPanel curve={CURVE} /> : <MorphPanel curve={CURVE} />}
      </aside>
      <div class="time">{bending ? Deform && <Deform.DeformStrip /> : <MorphStrip />}</div>
    </main>
  );
}

/** What is shown of closed curves is loaded when there are some, or when one may be chosen. */
const CurveChip = lazily(() => import("./views/curve").then((module) => module.CurveChip));
const CurveEvidence = lazily(() => import("./views/curve").then((module) => module.CurveEvidence));
const CURVE: CurveParts = {
  Panel: lazily(() => import("./views/curve").then((module) => module.CurvePanel)),
  Shelf: lazily(() => import("./views/curve").then((module) => module.Shelf)),
};

const deform = signal<typeof import("./views/deform") | null>(null);

/** The deformation tool is loaded when it is first opened. */
function loadDeform(): void {
  if (deform.peek()) return;
  import("./views/deform").then(
    (module) => {
      deform.value = module;
    },
    (problem) =>
      notify({ kind: "error", text: `The deformation grid could not be loaded: ${wordsOf(problem)}` }),
  );
}

type FiguresComponent = ComponentType<{ figure: string | null }>;
const figures = signal<FiguresComponent | null>(null);

/** The figures are loaded when they are first asked for. */
function FiguresPage({ figure }: { figure: string | null }) {
  useEffect(() => {
    if (figures.peek()) return;
    // Figures ask for small proofs on the spot.
    Promise.all([import("./figures/index"), loadProof()]).then(
      ([module]) => {
        figures.value = module.Figures;
      },
      (problem) => notify({ kind: "error", text: `The figures could not be loaded: ${wordsOf(problem)}` }),
    );
  }, []);
  const Figures = figures.value;
  return <main class="figures-page">{Figures ? <Figures figure={figure} /> : null}</main>;
}

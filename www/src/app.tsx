import { signal, useSignalEffect } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import type { PainterBackend } from "./canvas/painter";
import { Stage } from "./canvas/stage";
import { EvidencePanel } from "./shell/evidence/Panel";
import { Header } from "./shell/header";
import { Readout, VerdictChip } from "./shell/readouts";
import { route } from "./state/link";
import { announcement, dismiss, notices, notify, wordsOf } from "./state/notice";
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

function Studio({ backend }: { backend: "auto" | PainterBackend }) {
  return (
    <main class="studio">
      <h1 class="unseen">Frond: morph one fractal into another</h1>
      <Stage backend={backend}>
        <div class="stage-foot">
          <VerdictChip />
          <Readout />
        </div>
        <EvidencePanel />
      </Stage>
      <aside class="side" aria-label="Shapes and path">
        <MorphPanel />
      </aside>
      <div class="time">
        <MorphStrip />
      </div>
    </main>
  );
}

type FiguresComponent = ComponentType<{ figure: string | null }>;
const figures = signal<FiguresComponent | null>(null);

/** The figures are loaded when they are first asked for. */
function FiguresPage({ figure }: { figure: string | null }) {
  useEffect(() => {
    if (figures.peek()) return;
    import("./figures/index").then(
      (module) => {
        figures.value = module.Figures;
      },
      (problem) => notify({ kind: "error", text: `The figures could not be loaded: ${wordsOf(problem)}` }),
    );
  }, []);
  const Figures = figures.value;
  return <main class="figures-page">{Figures ? <Figures figure={figure} /> : null}</main>;
}

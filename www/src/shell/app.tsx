/** The whole page: header, the open tool or the figures, and notices. */
import { signal, useSignalEffect } from "@preact/signals";
import type { ComponentType } from "preact";
import { useEffect } from "preact/hooks";
import { sheetBehind } from "#document/kept/sheet";
import { type Place, route } from "#document/link";
import { notify, wordsOf } from "#document/notice";
import { exportOpen } from "#film/open";
import { Stage as SharedStage } from "#stage/stage";
import type { PainterBackend } from "#stage/surface/painter";
import { commandsOf } from "#stage/tool";
import { type Command, help, listenForCommands } from "#ui/commands";
import { openFile } from "#ui/files/door";
import { listenForFiles } from "#ui/files/dropFiles";
import { exporting } from "#ui/files/exporting";
import { lazily } from "#ui/lazy";
import { curvesFetched } from "#wasm/curve";
import { studioHref } from "./actions";
import { Header } from "./header";
import * as messages from "./messages";
import { Notices } from "./Notices";
import { Readout } from "./Readout";
import css from "./shell.module.css";
import { openedTool, TOOLS, watchTools } from "./tools";
/** The whole page. */
export function App({ backend }: { backend: "auto" | PainterBackend }) {
  const at = route.value;
  useSignalEffect(() => {
    document.title = `${PAGES[route.value.page]}Frond`;
  });
  return (
    <>
      <Header />
      {at.page === "studio" ? <Studio backend={backend} /> : <FiguresPage {...at} />}
      {/* A film goes on, and is shown, wherever one goes meanwhile. */}
      {at.page !== "studio" && exportOpen.value === "film" && <Exports />}
      <Notices />
    </>
  );
}

/** The tools share the stage, unless they have their own; each brings its own panel and its own strip. */
function Studio({ backend }: { backend: "auto" | PainterBackend }) {
  useEffect(() => {
    const stops = [watchTools(), listenForCommands(commands), listenForFiles(openFile)];
    return () => {
      for (const stop of stops) stop();
    };
  }, []);
  const { entry, tool } = openedTool();
  const { Stage, Overlay, Verdict, Evidence, Panel, Strip } = tool ?? {};
  const sheet = sheetBehind();
  return (
    <main class="studio">
      <h1 class="unseen">{entry.title}</h1>
      {/* It keeps its renderer while a tool with a picture of its own is open. */}
      <div class={entry.stage === undefined ? css["stage-here"] : css["stage-away"]}>
        <SharedStage backend={backend} overlay={Overlay && <Overlay />}>
          <div class="stage-foot">
            {Verdict && <Verdict />}
            <Readout />
          </div>
          {Evidence && <Evidence />}
        </SharedStage>
      </div>
      {entry.stage !== undefined && (
        <section class="stage" aria-label={entry.stage}>
          {Stage && <Stage backend={backend} />}
        </section>
      )}
      {/* Under the picture, and before all else for who comes by keys. */}
      <div class="time">{Strip && <Strip />}</div>
      <aside class="side" aria-label={entry.side}>
        {sheet && (
          <a class={css["back"]} href={sheet}>
            {messages.backToClassSheet}
          </a>
        )}
        {Panel && <Panel />}
      </aside>
      {help.value && <Help commands={commands} />}
      {exportOpen.value && <Exports />}
      {/* Tools that take files are fetched themselves: it comes with them. */}
      {(settled.value || typeof entry.tool === "function") && <Door />}
      {exporting.value && tool?.maps && <ExportDialog maps={tool.maps} onClose={endExport} />}
    </main>
  );
}

const helpDialog = () => import("./guide/Help").then((module) => module.Help);
const Help = lazily(helpDialog);

const exports = () => import("./Exports").then((module) => module.Exports);
const Exports = lazily(exports);
const exportDialog = () => import("#ui/files/ExportDialog").then((module) => module.ExportDialog);
const ExportDialog = lazily(exportDialog);
const endExport = () => {
  exporting.value = false;
};

const door = () => import("./door/Door").then((module) => module.Door);
/** What opens files. */
const Door = lazily(door);
/** Whether the first picture is there, so that others may be fetched. */
const settled = signal(false);

const NOTHING: readonly Command[] = [];
const commands = () => {
  const { tool } = openedTool();
  return tool ? commandsOf(tool) : NOTHING;
};

/** Fetches what tools may ask for later. */
export function fetchAhead(): void {
  const tried = () => {
    curvesFetched.value = true;
  };
  settled.value = true;
  Promise.all([
    helpDialog(),
    exports(),
    door(),
    exportDialog(),
    ...TOOLS.map((entry) => entry.fetchAhead?.()),
  ]).then(tried, tried);
}

const PAGES = { studio: "", figures: messages.figuresTitle, learn: messages.learnTitle };

type FiguresComponent = ComponentType<Omit<Place, "page"> & { place: Place["page"] }>;
const figures = signal<FiguresComponent | null>(null);

/** The figures and the lessons are loaded when they are first asked for. */
function FiguresPage({ page, ...at }: Place) {
  // The studio opens them.
  useEffect(
    () =>
      listenForFiles((files) => {
        location.hash = studioHref();
        openFile(files);
      }),
    [],
  );
  useEffect(() => {
    if (figures.peek()) return;
    import("#figures/index").then(
      (module) => {
        figures.value = module.Figures;
      },
      (problem) => notify({ kind: "error", text: messages.figuresFailed(wordsOf(problem)) }),
    );
  }, []);
  const Figures = figures.value;
  return <main class={css["figures-page"]}>{Figures ? <Figures place={page} {...at} /> : null}</main>;
}

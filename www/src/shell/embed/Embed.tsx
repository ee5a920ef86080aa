/** Frond in a frame of another page: a picture and a slider, and nothing else unless asked. */
import { useSignalEffect } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { type Place, route } from "#document/link";
import { setTheme } from "#document/preferences";
import { scene } from "#document/scene";
import { percent } from "#format/path-words";
import { fitCommand } from "#stage/commands";
import { Stage as SharedStage } from "#stage/stage";
import type { PainterBackend } from "#stage/surface/painter";
import { LocusBeside } from "#tools/morph/locus/LocusPanel";
import { listenForCommands } from "#ui/commands";
import { Icon } from "#ui/controls/Icon";
import { Slider } from "#ui/controls/Slider";
import { lazily } from "#ui/lazy";
import { PlayButton } from "#ui/strip/PlayButton";
import { timeCommands } from "#ui/strip/timeline";
import { studioHref } from "../actions";
import { Notices } from "../Notices";
import { openedTool, watchTools } from "../tools";
import css from "./embed.module.css";
import * as messages from "./messages";
import { optionsIn } from "./protocol";
import { momentNow, moving, seek, talk } from "./talk";

const options = optionsIn(location.search);
// The page around decides; what was chosen in the studio stays as it is.
if (options.theme) setTheme(options.theme, { keep: false });

export function Embed({ backend }: { backend: "auto" | PainterBackend }) {
  useEffect(() => {
    const stops = [
      watchTools(),
      listenForCommands(() => {
        const line = openedTool().tool?.timeline;
        return line ? [...timeCommands(line), fitCommand()] : [];
      }),
      talk(options.origin),
    ];
    return () => {
      for (const stop of stops) stop();
    };
  }, []);
  useSignalEffect(() => {
    if (route.value.page === "studio") document.title = openedTool().entry.title;
  });
  const at = route.value;
  if (at.page !== "studio") return <Page {...at} />;
  const { entry, tool } = openedTool();
  const { Stage, Verdict, Panel } = tool ?? {};
  const beside = (options.panel && Panel) || (options.locus && entry.id === "morph");
  return (
    <>
      <main class={`${css["embed"]} ${beside ? css["beside"] : ""}`}>
        <h1 class="unseen">{entry.title}</h1>
        <section class={css["picture"]} aria-label={entry.stage ?? messages.picture}>
          {entry.stage === undefined ? (
            <SharedStage backend={backend}>
              <div class="stage-foot">{options.verdict && Verdict && <Verdict />}</div>
            </SharedStage>
          ) : (
            Stage && <Stage backend={backend} />
          )}
        </section>
        {beside && (
          <aside class={css["side"]} aria-label={entry.side}>
            {options.panel && Panel ? <Panel /> : <LocusBeside />}
          </aside>
        )}
        <footer class={css["foot"]}>
          {options.controls && tool?.timeline && <Time />}
          <Out />
        </footer>
      </main>
      <Notices />
    </>
  );
}

/** A figure or a lesson. */
function Page({ page, figure, state }: Place) {
  return (
    <>
      <main class={css["embed"]}>
        <div class={css["page"]}>
          <Figures place={page} figure={figure} state={state} />
        </div>
        <footer class={css["foot"]}>
          <OutLink to={`#${[page, figure, state].filter(Boolean).join("/")}`} />
        </footer>
      </main>
      <Notices />
    </>
  );
}

const Figures = lazily(() => import("#figures/index").then((module) => module.Figures));

function Time() {
  const t = momentNow();
  return (
    <div class={css["time"]}>
      <PlayButton playing={moving()} onToggle={() => openedTool().tool?.timeline?.toggle()} />
      <Slider
        class={css["scrub"]}
        label={messages.time}
        value={t}
        step={0.01}
        valueText={percent(t)}
        onChange={seek}
      />
    </div>
  );
}

/** To the studio, with the document as it is when it last rested. */
function Out() {
  const rested = useRef("");
  scene.value;
  if (!moving()) rested.current = studioHref();
  return <OutLink to={rested.current} />;
}

function OutLink({ to }: { to: string }) {
  return (
    <a class={css["out"]} href={`./${to}`} target="_blank" rel="noopener">
      {messages.openInFrond}
      <Icon name="arrow" size={14} />
    </a>
  );
}

/** The stage that tools share: the main picture, the one it is compared with, and what lies over them. */
import { computed, signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { bend } from "#document/deform/bend";
import { pictureMaps, pictureShown, watchPicture } from "#document/deform/picture";
import { linear, mapsAt, morphOptions, selection, shown, uv } from "#document/morph";
import { scene } from "#document/scene";
import { standIn } from "#document/stand-in";
import { tool } from "#document/tool";
import { lazily } from "#ui/lazy";
import { stageKey } from "./gestures";
import * as messages from "./messages";
import { Picture } from "./picture";
import { shownWeights } from "./picture-style";
import css from "./stage.module.css";
import {
  type MainPainter,
  type Painter,
  type PainterBackend,
  type PainterState,
  UNSEEN,
} from "./surface/painter";
import { followFit } from "./view";
import { linkView } from "./view-link";

/** What the main picture is up to. */
export const picture = signal<PainterState>(UNSEEN);
export const mainPainter = signal<MainPainter | null>(null);
/** The same for the linear picture, while it stands beside the other. */
export const linearPicture = signal<PainterState | null>(null);
export const linearPainter = signal<Painter | null>(null);

/** What is to be seen in place of systems: a picture that is bent takes its place, too. */
const instead = computed(() => (pictureShown.value ? null : standIn.value));
const comparing = computed(
  () => scene.value.compare && selection.value === null && tool.value === "morph" && !instead.value,
);
/** Whoever edits maps sees them as they are. */
const mainBend = computed(() => (selection.value === null ? bend.value : null));
const polar = computed(() => mapsAt(uv.value, { ...morphOptions.value, mode: "polar" }));
/** The maps of the main picture. */
export const mainMaps = computed(() => {
  if (pictureShown.value) return pictureMaps.value;
  return comparing.value ? polar.value : shown.value;
});
const setPicture = (state: PainterState) => {
  picture.value = state;
};
const setPainter = (painter: MainPainter | null) => {
  mainPainter.value = painter;
  // What the last one was up to says nothing about the next.
  if (!painter) picture.value = UNSEEN;
};
const setLinearPicture = (state: PainterState) => {
  linearPicture.value = state;
};
const setLinearPainter = (painter: Painter | null) => {
  linearPainter.value = painter;
  if (!painter) linearPicture.value = null;
};

/** What is laid over the picture of systems: the evidence that is asked for, and the handles of the maps. */
export function MapOverlay() {
  if (instead.value) return null;
  return (
    <>
      {!comparing.value && <Evidence />}
      {selection.value !== null && <Handles />}
    </>
  );
}

/** The picture, as large as it can be: every tool draws on this one. */
export function Stage({
  backend,
  overlay,
  children,
}: {
  backend: "auto" | PainterBackend;
  /** What a tool lays over the picture. */
  overlay?: ComponentChildren;
  children?: ComponentChildren;
}) {
  useEffect(() => {
    const stopLink = linkView();
    const stopFit = followFit(everyFrame);
    const stopPicture = watchPicture();
    return () => {
      stopPicture();
      stopFit();
      stopLink();
    };
  }, []);
  const both = comparing.value;
  const bare = instead.value;
  return (
    <section class="stage" aria-label={messages.picture}>
      <div
        class={both ? `${css["pictures"]} two` : css["pictures"]}
        role="application"
        aria-label={messages.pictureKeys(
          bare === "curves" ? messages.curve : messages.attractor,
          tool.value === "morph" ? messages.describeKey : "",
        )}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it takes keys
        tabIndex={0}
        onKeyDown={(event) => {
          if (event.target === event.currentTarget && stageKey(event)) event.preventDefault();
        }}
      >
        <div class="pane">
          {bare ? (
            <StandInPicture onState={setPicture} onPainter={setPainter} />
          ) : (
            <Picture
              maps={mainMaps}
              weights={shownWeights}
              bend={mainBend}
              photograph={pictureShown}
              backend={backend}
              main
              onState={setPicture}
              onPainter={setPainter}
            />
          )}
          {both && <p class={css["pane-label"]}>{messages.byRotationPolar}</p>}
          {overlay}
        </div>
        {both && (
          <div class="pane">
            <Picture
              maps={linear}
              weights={shownWeights}
              bend={mainBend}
              backend={backend}
              onState={setLinearPicture}
              onPainter={setLinearPainter}
            />
            <p class={css["pane-label"]}>{messages.entryByEntryLinear}</p>
          </div>
        )}
      </div>
      <Empty />
      {children}
    </section>
  );
}

/** It lies over the picture, which does not wait for it. */
const Evidence = lazily(() => import("./evidence/marks").then((module) => module.Evidence));
/** Loaded with the panel of the maps. */
const Handles = lazily(() => import("./handles/Handles").then((module) => module.Handles));
/** Loaded when there is a curve to draw, or a graph-directed shape. */
const StandInPicture = lazily(() => import("./StandInPicture").then((module) => module.StandInPicture));

const empty = computed(() => picture.value.empty);

/** On its own, so that the count of points does not draw the whole stage again. */
function Empty() {
  if (!empty.value) return null;
  return <p class={css["stage-empty"]}>{messages.theseMapsHaveNo}</p>;
}

function everyFrame(tick: (now: number) => boolean): () => void {
  let frame = requestAnimationFrame(function step(now) {
    frame = tick(now) ? requestAnimationFrame(step) : 0;
  });
  return () => cancelAnimationFrame(frame);
}

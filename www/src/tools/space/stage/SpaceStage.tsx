import { computed, effect, signal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { endGesture } from "#document/scene";
import { chosen, hand, space, spaceView } from "#document/space/space";
import { watchSize } from "#stage/picture";
import type { PainterBackend } from "#stage/surface/painter";
import { BendHandles } from "../bend/Handles";
import * as messages from "../messages";
import { attachGestures } from "./gestures";
import { stageKey, stageKeyUp } from "./keys";
import { Messages } from "./Messages";
import { colours, ground, sight, watchGround } from "./sight";
import css from "./stage.module.css";
import { countsWords, handWords, statusWords } from "./stage-text";
import { painted, setPainter, spaceDrawn, stageSize } from "./state";
import { SpacePainter } from "./surface/painter";
import { Toolbar } from "./Toolbar";

const LABEL = messages.shapesInSpaceArrow;

/** As much is carved at most: a large screen with two pixels each way would take too long. */
const MOST_CARVED = 9e6;

const light = computed(() => space.value?.light ?? null);

/** Space, as large as it can be. */
export function SpaceStage({ backend }: { backend: "auto" | PainterBackend }) {
  const host = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = host.current;
    if (!element) return;
    const painter = new SpacePainter(element, {
      backend,
      onState: (state) => {
        painted.value = state;
      },
    });
    setPainter(painter);
    const device = signal({ width: 0, height: 0, ratio: 1 });
    const stopSize = watchSize(element, (css, now) => {
      device.value = now;
      stageSize.value = css;
    });
    const stopGround = watchGround();
    const stopBehind = effect(() => {
      element.style.background = ground.value;
    });
    const stopShow = effect(() => {
      const { width, height, ratio } = device.value;
      const now = sight.value;
      const view = spaceView.value;
      const lit = light.value;
      const look = { palette: colours.value, ground: ground.value };
      if (!now || !view || !lit || width === 0 || height === 0) return;
      const factor = ratio < 2 && 4 * width * height <= MOST_CARVED ? 2 : 1;
      painter.show({ ...look, sight: now, view, light: lit, width, height, factor });
    });
    const stopGestures = attachGestures(element);
    return () => {
      stopGestures();
      stopShow();
      stopBehind();
      stopGround();
      stopSize();
      setPainter(null);
      painter.close();
    };
  }, [backend]);
  return (
    <>
      <div
        ref={host}
        class={`picture ${css["space-canvas"]}`}
        role="application"
        aria-label={LABEL}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it takes keys
        tabIndex={0}
        data-testid="space-stage"
        onKeyDown={(event) => {
          if (event.target !== event.currentTarget || !stageKey(event)) return;
          event.preventDefault();
          event.stopPropagation();
        }}
        onKeyUp={stageKeyUp}
        onBlur={endGesture}
      />
      <BendHandles />
      <Toolbar />
      <Messages />
      <div class="stage-foot">
        <Status />
        <Chosen />
        <Counts />
      </div>
    </>
  );
}

const status = computed(() => statusWords(painted.value));

function Status() {
  return (
    <p class={`${css["space-status"]} number`} data-testid="space-status" data-drawn={spaceDrawn.value}>
      {status.value}
    </p>
  );
}

const about = computed(() => handWords(hand.value, space.value?.objects ?? [], chosen.value));

function Chosen() {
  if (about.value === null) return null;
  return (
    <p class={css["space-status"]} data-testid="space-chosen">
      {about.value}
    </p>
  );
}

const counts = computed(() => {
  const list = sight.value?.objects ?? [];
  return countsWords(
    list.length,
    list.reduce((sum, object) => sum + object.maps.length, 0),
  );
});

function Counts() {
  return (
    <p class={`${css["space-status"]} ${css["space-counts"]} number`}>{sight.value ? counts.value : ""}</p>
  );
}

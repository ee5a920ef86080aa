import { useEffect, useRef } from "preact/hooks";
import { MOST_ZOOM } from "#compute/locus/window";
import { along, locusWindow } from "#compute/results";
import { pathPoints } from "#document/morph";
import { percent } from "#format/path-words";
import { shareWords } from "#format/verdict";
import { uvAt } from "#geometry/path";
import { Field } from "#stage/locus/Field";
import { LocusProgress } from "#stage/locus/LocusProgress";
import type { LocusStyle } from "#stage/locus/paint";
import { CurrentHandle, WayHandle } from "#stage/locus/WayPoints";
import { IconButton } from "#ui/controls/Button";
import { pathKind } from "../document-signals";
import { FamilyLines, ToBoundary } from "../later";
import fieldCss from "./field.module.css";
import { End, PathLines, PickedMark } from "./marks";
import * as messages from "./messages";
import { PATH } from "./path/handles";
import { place, way } from "./path/waypoints";
import { CROSS_HINT, Cross, crossKey, useCross } from "./pointer/cross";
import { useGestures, wheelHint } from "./pointer/gestures";
import { followPointer } from "./pointer/hover";
import { Preview } from "./pointer/Preview";
import { full, large, toggleFull, toggleLarge } from "./view/large";
import { family, goHome, shownField, shownWindow, view, zoomBy } from "./view/view";

const STEP = 2;

/** What wheel and fingers do, as buttons, in a corner of the square. */
function ZoomButtons() {
  const { zoom } = view.value;
  return (
    <div class={fieldCss["locus-zoom"]}>
      {large.value && <IconButton icon="close" label={messages.backToPanel} onClick={toggleLarge} />}
      {large.value && (
        <IconButton
          icon="enlarge"
          label={messages.fullScreen}
          command="map-full"
          pressed={full.value}
          onClick={() => void toggleFull()}
        />
      )}
      <IconButton
        icon="add"
        label={messages.zoomIn}
        description={messages.orClickLocusAnd}
        disabled={zoom >= MOST_ZOOM}
        onClick={() => zoomBy(STEP)}
      />
      <IconButton
        icon="remove"
        label={messages.zoomOut}
        disabled={zoom <= 1}
        onClick={() => zoomBy(1 / STEP)}
      />
      <IconButton icon="whole" label={messages.resetView} disabled={zoom <= 1} onClick={goHome} />
    </div>
  );
}

const LABELS = {
  morph: messages.locusOverUTo,
  polygon: messages.locusOverSReal,
};

/** The field with what lies on it. */
export function LocusSquare({ style }: { style: LocusStyle }) {
  const square = useRef<HTMLDivElement>(null);
  const pointer = useGestures(square);
  const cross = useCross();
  useEffect(followPointer, []);
  const { zoom } = view.value;
  const progress = locusWindow.value?.progress ?? 0;
  const problem = locusWindow.value?.problem ?? null;
  return (
    <div class={`locus-square ${pathKind.value} ${zoom > 1 ? "near" : ""}`} ref={square} {...pointer}>
      <div
        class="locus-plane"
        role="application"
        aria-label={`${LABELS[family.value]} ${CROSS_HINT}`}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: it takes keys
        tabIndex={0}
        onKeyDown={crossKey}
        {...cross}
      >
        <Field samples={shownField.value} frame={shownWindow.value} style={style} />
      </div>
      {family.value === "morph" ? <OnMorph /> : <FamilyLines />}
      <PickedMark />
      <Cross />
      <ZoomButtons />
      <ToBoundary />
      {wheelHint.value && (
        <p class={fieldCss["wheel-hint"]} aria-hidden="true">
          {messages.clickLocusOrHold}
        </p>
      )}
      {problem !== null && <p class="locus-problem">{problem}</p>}
      <LocusProgress share={progress} />
      <Preview square={square} />
    </div>
  );
}

/** The path and what can be taken hold of on it. */
function OnMorph() {
  const window = shownWindow.value;
  return (
    <>
      <PathLines />
      <WorstMark />
      <End letter="A" at={place([0, 0], window)} />
      <End letter="B" at={place([1, 1], window)} />
      <CurrentHandle path={PATH} />
      {way.value.map((_, index) => (
        // Waypoints have no name but their number: it is their key, so that focus stays while one is moved.
        <WayHandle key={index} path={PATH} index={index} />
      ))}
    </>
  );
}

/** Where the gap is widest along the path. It takes no hold: handles may lie under it. */
function WorstMark() {
  const worst = along.value?.worst;
  if (!worst) return null;
  const [x, y] = place(uvAt(pathPoints.value, worst.t), shownWindow.value);
  if (!(x >= 0 && x <= 1 && y >= 0 && y <= 1)) return null;
  return (
    <span
      class="worst-mark"
      style={{ left: `${100 * x}%`, top: `${100 * y}%` }}
      role="img"
      aria-label={messages.worstAt(shareWords(worst.gap), percent(worst.t))}
    />
  );
}

import { useEffect, useRef } from "preact/hooks";
import { locusWindow } from "#compute/results";
import { Field } from "#stage/locus/Field";
import { LocusProgress } from "#stage/locus/LocusProgress";
import type { LocusStyle } from "#stage/locus/paint";
import { CurrentHandle, WayHandle } from "#stage/locus/WayPoints";
import { FamilyLines, ToBoundary } from "../later";
import { pathKind } from "../parts";
import fieldCss from "./field.module.css";
import { End, PathLines, PickedMark } from "./marks";
import * as messages from "./messages";
import { PATH } from "./path/handles";
import { WorstMark } from "./path/WorstMark";
import { place, way } from "./path/way";
import { CROSS_HINT, Cross, crossKey, useCross } from "./pointer/cross";
import { useGestures, wheelHint } from "./pointer/gestures";
import { followPointer } from "./pointer/hover";
import { Preview } from "./pointer/Preview";
import { shownField } from "./view/shown";
import { family, shownWindow, view } from "./view/view";
import { ZoomButtons } from "./view/ZoomButtons";

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

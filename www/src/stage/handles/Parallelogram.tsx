import { type Screen, screen, toScreen, type World } from "#geometry/coordinates";
import { armOf, type Corners, cornersOf, GRIPS, type Grip, middleOf } from "#geometry/parallelogram";
import type { MapRow } from "#wasm/api";
import * as messages from "../messages";
import css from "../stage.module.css";
import { effectiveView, stageSize } from "../view";
import { DOES, type Held, useHeldGrip, useHeldTurner } from "./held";

/** How far from its side the handle stands that only turns it. */
const ARM = 30;

/** How near to its middle a number is pressed. */
export const TAG = 13;

export function place(p: World): Screen {
  return toScreen(p, effectiveView.value, stageSize.value);
}

function between(p: Screen, q: Screen): Screen {
  return screen((p.x + q.x) / 2, (p.y + q.y) / 2);
}

export function Outline({ corners, class: name }: { corners: Corners; class: string }) {
  return <path class={name} d={outline(corners)} />;
}

function outline(corners: Corners): string {
  const points = [corners.origin, corners.x, corners.turn, corners.y].map(place);
  return `M${points.map((p) => `${p.x.toFixed(2)} ${p.y.toFixed(2)}`).join("L")}Z`;
}

interface ParallelogramProps {
  held: Held;
  map: MapRow;
  colour: string;
  chosen: boolean;
  /** Where there are several: chooses this one. */
  choose?: () => void;
}

/** What is held. */
export function Parallelogram({ held, map, colour, chosen, choose }: ParallelogramProps) {
  const corners = cornersOf(map, held.box());
  return (
    <g class={chosen ? `${css["map"]} chosen` : css["map"]} style={{ color: colour }}>
      {/* biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG */}
      <path
        class={css["body"]}
        data-handle=""
        role="button"
        // In lower case: SVG knows no other, and without it Tab passes by.
        tabindex={0}
        aria-label={chosen ? (choose ? messages.chosenHandle : messages.onlyHandle)(held.name) : held.name}
        {...(choose ? { "aria-pressed": chosen } : {})}
        d={outline(corners)}
        ref={useHeldGrip(held, "origin", choose)}
      />
      <path class={css["edge"]} d={outline(corners)} />
    </g>
  );
}

/** The handles of what is chosen, above all else: a drag that begins on one is for it. */
export function Grips({ held, map, colour }: Pick<ParallelogramProps, "held" | "map" | "colour">) {
  const corners = cornersOf(map, held.box());
  return (
    <g style={{ color: colour }}>
      {GRIPS.map((grip) => (
        <Handle key={grip} held={held} grip={grip} at={place(corners[grip])} />
      ))}
      <Turner held={held} corners={corners} />
    </g>
  );
}

/** The middle of what is held. */
export function middleSeen(held: Held, map: MapRow): Screen {
  const corners = cornersOf(map, held.box());
  return between(place(corners.x), place(corners.y));
}

/** Its number, which moves it as its body does, whatever else lies there. Keys have the body. */
export function Tag({
  held,
  mark,
  at,
  choose,
}: {
  held: Held;
  mark: string;
  at: Screen;
  choose: () => void;
}) {
  return (
    <g
      class={css["tag"]}
      data-handle=""
      // What listens can take the focus in some browsers: keys have the body.
      tabindex={-1}
      transform={`translate(${at.x} ${at.y})`}
      ref={useHeldGrip(held, "origin", choose)}
    >
      <circle class={css["reach"]} r={TAG} />
      <text class={`${css["number-label"]} ${css["cased"]}`} y={5}>
        {mark}
      </text>
    </g>
  );
}

function Handle({ held, grip, at }: { held: Held; grip: Grip; at: Screen }) {
  return (
    // biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG
    <g
      class={`grip ${grip}`}
      data-handle=""
      role="button"
      tabindex={0}
      aria-label={messages.gripOf(held.name, DOES[grip])}
      transform={`translate(${at.x} ${at.y})`}
      ref={useHeldGrip(held, grip)}
    >
      <circle class={css["reach"]} r={22} />
      {grip === "turn" ? (
        <rect class="knob" x={-6} y={-6} width={12} height={12} rx={2} />
      ) : (
        <circle class="knob" r={7} />
      )}
    </g>
  );
}

/** A ring round the place where a drag has come to rest. */
export function Resting({ at }: { at: Screen }) {
  return <circle class="link-ring" cx={at.x} cy={at.y} r={12} />;
}

/** Where the handle stands that only turns it: beyond the side across from the first one. */
function turnerAt(corners: Corners): Screen {
  const from = place(middleOf(corners));
  const to = between(place(corners.y), place(corners.turn));
  const [dx, dy] = armOf(corners);
  const half = Math.hypot(to.x - from.x, to.y - from.y);
  const out = screen(from.x + (half + ARM) * dx, from.y - (half + ARM) * dy);
  const { width, height } = stageSize.value;
  const seen = Math.min(out.x, out.y, width - out.x, height - out.y) > ARM / 2;
  // Where that is off the stage it stands on the map itself.
  return seen ? out : screen(from.x + (half - ARM) * dx, from.y - (half - ARM) * dy);
}

function Turner({ held, corners }: { held: Held; corners: Corners }) {
  const from = place(middleOf(corners));
  const at = turnerAt(corners);
  return (
    <>
      <line class={css["arm-halo"]} x1={from.x} y1={from.y} x2={at.x} y2={at.y} />
      <line class={css["arm"]} x1={from.x} y1={from.y} x2={at.x} y2={at.y} />
      {/* biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG */}
      <g
        class="grip turn"
        data-handle=""
        role="button"
        tabindex={0}
        aria-label={messages.turnerOf(held.name)}
        transform={`translate(${at.x} ${at.y})`}
        ref={useHeldTurner(held, turnerAt)}
      >
        <circle class={css["reach"]} r={22} />
        <circle class={css["turner-ground"]} r={11} />
        <path class="knob" d="M5 -4A6.500 6.500 0 1 0 6.500 1M6 -8V-3.500H1.500" />
      </g>
    </>
  );
}

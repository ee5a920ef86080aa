/** The maps of a shape, drawn over the picture to be dragged. */
import { computed, signal, useSignalEffect } from "@preact/signals";
import { type Box, boxOf } from "#document/framing";
import { selection } from "#document/morph";
import { announce } from "#document/notice";
import { edit, inGesture, scene } from "#document/scene";
import { lengthWords } from "#format/verdict";
import { type Screen, screen, toScreen, toWorld, type World } from "#geometry/coordinates";
import { mapWords } from "#geometry/maps/affine2";
import {
  armOf,
  type Corners,
  cornersOf,
  dragged,
  GRIPS,
  type Grip,
  middleOf,
  turned,
} from "#geometry/parallelogram";
import { restsOf, snapped, spun } from "#geometry/snap";
import type { MapRow, Shape } from "#wasm/api";
import { useGrip } from "./grip";
import { stageStyle } from "./picture-style";
import css from "./stage.module.css";
import { effectiveView, stageSize } from "./view";

const UNIT: Box = { x0: 0, y0: 0, x1: 1, y1: 1 };
const STEP = 10;
const FINE = 1;

const NAMES: Record<Grip, string> = {
  origin: "moves it",
  x: "first side",
  y: "second side",
  turn: "turns and scales it",
};

/** How near, in CSS pixels, what is dragged has to come to rest at something. */
const REACH = 8;
/** How far from the side of a map the handle stands that only turns it. */
const ARM = 30;
/** By how much a key turns a map, in degrees. */
const TURN = 5;

/** Whether what is dragged comes to rest at the other maps. Alt does the opposite. */
export const snapping = signal(true);
/** Where it rests just now. */
const rest = signal<World | null>(null);

const shape = computed<Shape | null>(() => {
  const target = selection.value?.target;
  return target ? scene.value[target] : null;
});

/** The box whose images are shown. It stands still while a map is dragged, although the attractor changes. */
const frame = signal<Box>(UNIT);

/** The maps of the shape that is edited, as parallelograms: the images of the box of the whole. */
export function Handles() {
  const maps = shape.value?.maps;
  useSignalEffect(() => {
    const now = shape.value?.maps;
    if (now && !inGesture.value) frame.value = boxOf(now) ?? frame.peek();
  });
  const chosen = selection.value;
  if (!maps || !chosen) return null;
  const size = stageSize.value;
  // The chosen one last, so that it lies on top.
  const order = maps.map((_, i) => i).sort((p, q) => Number(p === chosen.map) - Number(q === chosen.map));
  return (
    <svg class="overlay" width={size.width} height={size.height}>
      <title>Maps of the shape as parallelograms</title>
      <Outline corners={cornersOf([1, 0, 0, 1, 0, 0], frame.value)} class="frame" />
      {inGesture.value && rest.value && <Resting at={place(rest.value)} />}
      {order.map((i) => {
        const map = maps[i];
        if (!map) return null;
        const colour = stageStyle.value.palette[i % stageStyle.value.palette.length] ?? "currentColor";
        return <OneMap key={i} index={i} map={map} colour={colour} chosen={i === chosen.map} />;
      })}
    </svg>
  );
}

function Outline({ corners, class: name }: { corners: Corners; class: string }) {
  return <path class={name} d={outline(corners)} />;
}

function outline(corners: Corners): string {
  const points = [corners.origin, corners.x, corners.turn, corners.y].map(place);
  return `M${points.map((p) => `${p.x.toFixed(2)} ${p.y.toFixed(2)}`).join("L")}Z`;
}

function place(p: World): { x: number; y: number } {
  return toScreen(p, effectiveView.value, stageSize.value);
}

function between(p: { x: number; y: number }, q: { x: number; y: number }): { x: number; y: number } {
  return { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 };
}

interface OneMapProps {
  index: number;
  map: MapRow;
  colour: string;
  chosen: boolean;
}

function OneMap({ index, map, colour, chosen }: OneMapProps) {
  const corners = cornersOf(map, frame.value);
  const middle = between(place(corners.x), place(corners.y));
  const choose = () => {
    const now = selection.peek();
    if (now) selection.value = { ...now, map: index };
  };
  return (
    <g class={chosen ? `${css["map"]} chosen` : css["map"]} style={{ color: colour }}>
      {/* biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG */}
      <path
        class={css["body"]}
        data-handle=""
        role="button"
        // In lower case: SVG knows no other, and without it Tab passes by.
        tabindex={0}
        aria-label={`Map ${index + 1}${chosen ? ", chosen; arrow keys move it" : ""}`}
        aria-pressed={chosen}
        d={outline(corners)}
        ref={useMapGrip(index, "origin", choose)}
      />
      <path class={css["edge"]} d={outline(corners)} />
      <text class={`${css["number-label"]} ${css["cased"]}`} x={middle.x} y={middle.y + 5}>
        {index + 1}
      </text>
      {chosen &&
        GRIPS.map((grip) => <Handle key={grip} index={index} grip={grip} at={place(corners[grip])} />)}
      {chosen && <Turner index={index} corners={corners} />}
    </g>
  );
}

function Handle({ index, grip, at }: { index: number; grip: Grip; at: { x: number; y: number } }) {
  return (
    // biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG
    <g
      class={`grip ${grip}`}
      data-handle=""
      role="button"
      tabindex={0}
      aria-label={`Map ${index + 1}, ${NAMES[grip]}: arrow keys, with Shift finer`}
      transform={`translate(${at.x} ${at.y})`}
      ref={useMapGrip(index, grip)}
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
function Resting({ at }: { at: { x: number; y: number } }) {
  return <circle class="link-ring" cx={at.x} cy={at.y} r={12} />;
}

/** Where the handle stands that only turns a map: beyond the side across from the first one. */
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

function Turner({ index, corners }: { index: number; corners: Corners }) {
  const from = place(middleOf(corners));
  const at = turnerAt(corners);
  const now = () => {
    const map = shape.peek()?.maps[index];
    return map ? turnerAt(cornersOf(map, frame.peek())) : null;
  };
  const grip = useGrip({
    take(event) {
      event.stopPropagation();
      return now();
    },
    moveTo(to, free) {
      const point = toWorld(to, effectiveView.peek(), stageSize.peek());
      rest.value = null;
      change(index, (map) => spun(map, frame.peek(), point, free === snapping.peek()), `turn ${index}`);
    },
    key(event) {
      const [x = 0, y = 0] = ARROWS[event.key] ?? [];
      if ((x === 0 && y === 0) || event.ctrlKey || event.metaKey || event.altKey) return false;
      const by = ((event.shiftKey ? 1 : TURN) * (x > 0 || y > 0 ? -1 : 1) * Math.PI) / 180;
      const { scale } = effectiveView.peek();
      change(index, (map) => rounded(turned(map, frame.peek(), by), scale), `turn keys ${index}`);
      const map = shape.peek()?.maps[index];
      if (map) announce(`Map ${index + 1}: ${mapWords(map)}`);
      return true;
    },
  });
  return (
    <>
      <line class={css["arm"]} x1={from.x} y1={from.y} x2={at.x} y2={at.y} />
      {/* biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG */}
      <g
        class="grip turn"
        data-handle=""
        role="button"
        tabindex={0}
        aria-label={`Map ${index + 1}, only turns it: arrow keys, with Shift finer`}
        transform={`translate(${at.x} ${at.y})`}
        ref={grip}
      >
        <circle class={css["reach"]} r={22} />
        <path class="knob" d="M5 -4A6.500 6.500 0 1 0 6.500 1M6 -8V-3.500H1.500" />
      </g>
    </>
  );
}

/** Drags and arrow keys for one grip. */
const useMapGrip = (index: number, grip: Grip, onTake?: () => void) =>
  useGrip({
    take(event) {
      event.stopPropagation();
      onTake?.();
      return gripPlace(index, grip);
    },
    moveTo: (to, free) => moveTo(index, grip, to, `drag ${index} ${grip}`, free !== snapping.peek()),
    key(event) {
      if (onTake && (event.key === "Enter" || event.key === " ")) {
        onTake();
        return true;
      }
      const step = ARROWS[event.key];
      const at = gripPlace(index, grip);
      if (!step || !at || event.ctrlKey || event.metaKey || event.altKey) return false;
      const far = event.shiftKey ? FINE : STEP;
      moveTo(index, grip, { x: at.x + far * step[0], y: at.y + far * step[1] }, `keys ${index} ${grip}`);
      say(index, grip);
      return true;
    },
  });

const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

function gripPlace(index: number, grip: Grip): Screen | null {
  const map = shape.peek()?.maps[index];
  return map ? toScreen(cornersOf(map, frame.peek())[grip], effectiveView.peek(), stageSize.peek()) : null;
}

function moveTo(index: number, grip: Grip, to: { x: number; y: number }, gesture: string, rests = false) {
  const view = effectiveView.peek();
  const point = toWorld(screen(to.x, to.y), view, stageSize.peek());
  change(
    index,
    (map, maps) => {
      const box = frame.peek();
      if (rests) {
        const found = snapped(map, box, grip, point, restsOf(maps, index, box), REACH / view.scale);
        rest.value = found.at;
        // What rests is exact, and stays so.
        if (found.at) return found.map;
      } else rest.value = null;
      return rounded(dragged(map, box, grip, point), view.scale);
    },
    gesture,
  );
}

/** Another map in the place of one; a run of them is one step of undo. */
function change(index: number, to: (map: MapRow, maps: readonly MapRow[]) => MapRow, gesture: string): void {
  const target = selection.peek()?.target;
  if (!target) return;
  edit(
    (before) => {
      const map = before[target].maps[index];
      if (!map) return before;
      const maps = before[target].maps.with(index, to(map, before[target].maps));
      // Touched maps are no preset any more.
      return { ...before, [target]: { name: before[target].name, maps } };
    },
    { gesture },
  );
}

/** Numbers as fine as a hundredth of a pixel, which keeps links short. */
function rounded(map: MapRow, scale: number): MapRow {
  const digits = Math.min(14, Math.max(3, Math.ceil(Math.log10(100 * scale))));
  return map.map((x) => Number(x.toFixed(digits))) as MapRow;
}

function say(index: number, grip: Grip): void {
  const map = shape.peek()?.maps[index];
  if (!map) return;
  const { x, y } = cornersOf(map, frame.peek())[grip];
  announce(`Map ${index + 1}, ${NAMES[grip]}: ${lengthWords(x)}, ${lengthWords(y)}`);
}

import { announce } from "#document/notice";
import { formatNumber } from "#format/numbers";
import { screen, toScreen, toWorld, world } from "#geometry/coordinates";
import { useGrip } from "#stage/grip";
import stageCss from "#stage/stage.module.css";
import css from "../../graph/graph.module.css";
import { rounded } from "../../graph/stage/frame";
import * as messages from "../../messages";
import { type Point, withoutPoint, withPlace } from "../model/curve";
import { change, chosenPoint, curve } from "../model/document";
import { stageBox, view } from "./shown";

/** More handles than this would be a wall: then only the chosen one is there. */
const MOST_HANDLES = 80;
/** Up to here every point has its number beside it. */
const LABELLED = 12;
const STEP = 10;

/** The points that the curve goes through, to be dragged anywhere. */
export function Points() {
  const { points } = curve.value;
  const { width, height } = stageBox.value;
  const many = points.length > MOST_HANDLES;
  return (
    <svg class={`overlay ${css["graph-knots"]}`} width={width} height={height}>
      <title>{messages.pointsCurve}</title>
      {points.map((point, index) =>
        many && index !== chosenPoint.value ? null : <Handle key={index} index={index} point={point} />,
      )}
    </svg>
  );
}

function Handle({ index, point: [, x, y] }: { index: number; point: Point }) {
  const now = view.value;
  const at = toScreen(world(x, y), now, stageBox.value);
  const chosen = index === chosenPoint.value;
  const count = curve.value.points.length;
  return (
    // biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG
    <g
      class={`grip ${css["knot"]} ${chosen ? css["chosen"] : ""}`}
      data-handle=""
      role="button"
      tabindex={0}
      aria-label={messages.curvePointAt(index + 1, words(x), words(y))}
      transform={`translate(${at.x.toFixed(2)} ${at.y.toFixed(2)})`}
      ref={usePointGrip(index)}
    >
      <circle class={stageCss["reach"]} r={22} />
      <circle class="knob" r={6.5} />
      {(chosen || count <= LABELLED) && (
        <text class={`${css["knot-label"]} ${stageCss["cased"]}`} x={10} y={-10}>
          {chosen ? `${index + 1}: ${words(x)}, ${words(y)}` : index + 1}
        </text>
      )}
    </g>
  );
}

/** As many digits as a pixel tells apart. */
function words(x: number): string {
  return formatNumber(x, Math.min(12, Math.max(2, Math.ceil(Math.log10(view.peek().scale)))));
}

const ARROWS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** Moves a point by pixels of the stage: the number across the way stays to the last digit. */
function nudge(index: number, [across, up]: readonly [number, number], pixels: number): void {
  const point = curve.peek().points[index];
  if (!point) return;
  const one = 1 / view.peek().scale;
  const moved = (from: number, way: number) => (way === 0 ? from : rounded(from + way * pixels * one, one));
  const to = [moved(point[1], across), moved(point[2], up)] as const;
  if (change((now) => withPlace(now, index, to), `keys point ${index}`)) {
    announce(messages.curvePointNow(index + 1, words(to[0]), words(to[1])));
  }
}

const usePointGrip = (index: number) =>
  useGrip({
    take() {
      const point = curve.peek().points[index];
      if (!point) return null;
      chosenPoint.value = index;
      return toScreen(world(point[1], point[2]), view.peek(), stageBox.peek());
    },
    moveTo({ x, y }) {
      const to = toWorld(screen(x, y), view.peek(), stageBox.peek());
      const one = 1 / view.peek().scale;
      change((now) => withPlace(now, index, [rounded(to.x, one), rounded(to.y, one)]), `drag point ${index}`);
    },
    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return false;
      const arrow = ARROWS[event.key];
      if (arrow) nudge(index, arrow, event.shiftKey ? 1 : STEP);
      else if (event.key === "Delete" || event.key === "Backspace") change((now) => withoutPoint(now, index));
      else return false;
      return true;
    },
    focus() {
      chosenPoint.value = index;
    },
  });

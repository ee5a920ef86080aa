import { announce } from "#document/notice";
import { formatNumber } from "#format/numbers";
import { screen } from "#geometry/coordinates";
import { useGrip } from "#stage/grip";
import stageCss from "#stage/stage.module.css";
import graphCss from "../graph.module.css";
import * as messages from "../messages";
import { changeModel, chosenKnot, model } from "../model/document";
import type { Knot } from "../model/model";
import { withKnot, withoutKnot } from "../model/model";
import { type Frame, leftOf, rounded, tAt, topOf, xAt } from "./frame";
import { frame, isShown } from "./view";

/** More handles than this would be a wall: then only the chosen one is there. */
const MOST_HANDLES = 80;
/** Up to here every knot has its numbers beside it. */
const LABELLED = 9;
const STEP = 10;

/** The points that the graph goes through, to be dragged. */
export function Knots({ faint }: { faint: boolean }) {
  const { knots } = model.value;
  const view = frame.value;
  const chosen = chosenKnot.value;
  const seen = knots.map((knot, index) => ({ knot, index })).filter(({ knot }) => isShown(knot[0]));
  const shown = seen.length > MOST_HANDLES ? seen.filter(({ index }) => index === chosen) : seen;
  const width = view.left + view.width + 40;
  return (
    <svg class={`overlay ${graphCss["graph-knots"]}`} width={width} height={view.top + view.height + 90}>
      <title>{messages.pointsGraph}</title>
      {shown.map(({ knot, index }) => (
        <Handle
          key={index}
          index={index}
          knot={knot}
          view={view}
          labelled={!faint && (shown.length <= LABELLED || index === chosen)}
        />
      ))}
    </svg>
  );
}

function Handle({
  index,
  knot,
  view,
  labelled,
}: {
  index: number;
  knot: Knot;
  view: Frame;
  labelled: boolean;
}) {
  const [left, top] = [leftOf(view, knot[0]), topOf(view, knot[1])];
  const words = numbers(knot, view);
  const room = view.left + view.width - left;
  return (
    // biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG
    <g
      class={
        index === chosenKnot.value
          ? `grip ${graphCss["knot"]} ${graphCss["chosen"]}`
          : `grip ${graphCss["knot"]}`
      }
      data-handle=""
      role="button"
      tabindex={0}
      aria-label={messages.knotAt(index + 1, words[0], words[1])}
      transform={`translate(${left.toFixed(2)} ${top.toFixed(2)})`}
      ref={useKnotGrip(index)}
    >
      <circle class={stageCss["reach"]} r={22} />
      <circle class="knob" r={6.5} />
      {labelled && (
        <text
          class={`${graphCss["knot-label"]} ${stageCss["cased"]}`}
          x={room < 90 ? -11 : 11}
          y={-11}
          text-anchor={room < 90 ? "end" : "start"}
        >
          {`${words[0]}, ${words[1]}`}
        </text>
      )}
    </g>
  );
}

/** As many digits as a pixel tells apart. */
function numbers([t, x]: Knot, view: Frame): [string, string] {
  const digits = (perPixel: number) => Math.min(12, Math.max(2, Math.ceil(-Math.log10(perPixel))));
  return [
    formatNumber(t, digits((view.t[1] - view.t[0]) / view.width)),
    formatNumber(x, digits((view.x[1] - view.x[0]) / view.height)),
  ];
}

/** Moves a knot to a place of the stage. */
function moveTo(index: number, left: number, top: number, gesture: string): void {
  const view = frame.peek();
  const to: Knot = [
    rounded(tAt(view, left), (view.t[1] - view.t[0]) / view.width),
    rounded(xAt(view, top), (view.x[1] - view.x[0]) / view.height),
  ];
  changeModel((now) => withKnot(now, index, to), gesture);
}

const ARROWS: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Moves a knot by pixels of the stage, only in the direction asked for: the other number stays to the last digit. */
function nudge(index: number, [across, down]: readonly [number, number], pixels: number): void {
  const knot = model.peek().knots[index];
  if (!knot) return;
  const view = frame.peek();
  const perPixel = [(view.t[1] - view.t[0]) / view.width, (view.x[1] - view.x[0]) / view.height] as const;
  const to: Knot = [
    across === 0 ? knot[0] : rounded(knot[0] + across * pixels * perPixel[0], perPixel[0]),
    down === 0 ? knot[1] : rounded(knot[1] - down * pixels * perPixel[1], perPixel[1]),
  ];
  changeModel((now) => withKnot(now, index, to), `keys knot ${index}`);
  const moved = model.peek().knots[index];
  if (moved) announce(messages.pointAt(index + 1, numbers(moved, view).join(", ")));
}

const useKnotGrip = (index: number) =>
  useGrip({
    take() {
      const knot = model.peek().knots[index];
      if (!knot) return null;
      chosenKnot.value = index;
      const view = frame.peek();
      return screen(leftOf(view, knot[0]), topOf(view, knot[1]));
    },
    moveTo: ({ x, y }) => moveTo(index, x, y, `drag knot ${index}`),
    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return false;
      const arrow = ARROWS[event.key];
      if (arrow) nudge(index, arrow, event.shiftKey ? 1 : STEP);
      else if (event.key === "Delete" || event.key === "Backspace")
        changeModel((now) => withoutKnot(now, index));
      else return false;
      return true;
    },
    focus() {
      chosenKnot.value = index;
    },
  });

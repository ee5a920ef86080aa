/** The frame of the shape that is edited, drawn by two of its corners. */
import { signal } from "@preact/signals";
import { editFrame, setFrame } from "#document/editing/frame";
import { selection } from "#document/morph";
import { announce } from "#document/notice";
import { scene } from "#document/scene";
import { lengthWords } from "#format/verdict";
import type { Box } from "#geometry/boxes";
import { screen, toScreen, toWorld, world } from "#geometry/coordinates";
import { useGrip } from "../grip";
import * as messages from "../messages";
import css from "../stage.module.css";
import { effectiveView, stageSize } from "../view";
import { ARROWS, foreign } from "./held";
import { place } from "./Parallelogram";

/** Whether the panel speaks of the frame: then its corners can be dragged. */
export const frameShown = signal(false);

const CORNERS = [
  { x: "x0", y: "y0", name: messages.lowerLeft },
  { x: "x1", y: "y1", name: messages.upperRight },
] as const;
type Corner = (typeof CORNERS)[number];

/** The least side of a frame, in CSS pixels: it can be taken hold of again. */
const LEAST = 24;
const STEP = 10;
/** How far outside its corner a handle stands. */
const OUT = 12;

export function FrameGrips() {
  const frame = editFrame.value;
  if (!frame || frame.follows) return null;
  return (
    <>
      {CORNERS.map((corner) => (
        <FrameGrip key={corner.name} corner={corner} box={frame.box} />
      ))}
    </>
  );
}

function FrameGrip({ corner, box }: { corner: Corner; box: Box }) {
  const { x, y } = place(world(box[corner.x], box[corner.y]));
  // Outside the frame, so that it covers no corner of a map in the frame's own corner.
  const out = corner.x === "x0" ? 1 : -1;
  const at = { x: x - OUT * out, y: y + OUT * out };
  return (
    // biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG
    <g
      class="grip"
      data-handle=""
      role="button"
      tabindex={0}
      aria-label={messages.frameCorner(corner.name)}
      transform={`translate(${at.x} ${at.y})`}
      ref={useGrip({
        take(event) {
          event.stopPropagation();
          const now = editFrame.peek()?.box;
          return now
            ? toScreen(world(now[corner.x], now[corner.y]), effectiveView.peek(), stageSize.peek())
            : null;
        },
        moveTo(to) {
          const { x, y } = toWorld(screen(to.x, to.y), effectiveView.peek(), stageSize.peek());
          moveCorner(corner, x, y);
        },
        key(event) {
          const now = editFrame.peek()?.box;
          const step = ARROWS[event.key];
          if (!now || !step || foreign(event)) return false;
          const by = (event.shiftKey ? 1 : STEP) / effectiveView.peek().scale;
          moveCorner(corner, now[corner.x] + by * step[0], now[corner.y] - by * step[1]);
          const { x, y } = { x: editFrame.peek()?.box[corner.x], y: editFrame.peek()?.box[corner.y] };
          announce(messages.frameCornerAt(corner.name, lengthWords(x ?? 0), lengthWords(y ?? 0)));
          return true;
        },
      })}
    >
      <circle class={css["reach"]} r={22} />
      <path class={css["frame-corner"]} d={`M0 ${-14 * out}V0H${14 * out}`} />
    </g>
  );
}

/** One corner elsewhere, as fine as a hundredth of a pixel; the other stays, and it never passes that. */
function moveCorner(corner: Corner, x: number, y: number): void {
  const editing = selection.peek();
  const now = editFrame.peek();
  if (!(editing && now)) return;
  const { scale } = effectiveView.peek();
  const least = LEAST / scale;
  const digits = Math.min(14, Math.max(2, Math.ceil(Math.log10(10 * scale))));
  const round = (z: number) => Number(z.toFixed(digits));
  const box = { ...now.box };
  if (corner.x === "x0") {
    box.x0 = round(Math.min(x, box.x1 - least));
    box.y0 = round(Math.min(y, box.y1 - least));
  } else {
    box.x1 = round(Math.max(x, box.x0 + least));
    box.y1 = round(Math.max(y, box.y0 + least));
  }
  setFrame(scene.peek()[editing.target].maps, box, { byHand: true });
}

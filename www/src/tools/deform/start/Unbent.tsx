import { pieceColours } from "#document/colours";
import { backToSystems } from "#document/curve/back";
import { bendPicture } from "#document/deform/bend-picture";
import { directedMoment } from "#document/directed/directed";
import { fitFor } from "#document/framing";
import { announce, notify, wordsOf } from "#document/notice";
import { dark } from "#document/preferences";
import { scene } from "#document/scene";
import { directedBoxAt, endsOf } from "#document/stand-in";
import { openTool } from "#document/tool";
import { directedLook } from "#stage/directed/options";
import { Button } from "#ui/controls/Button";
import { PanelFoot } from "#ui/panel/PanelFoot";
import { directedTask } from "#workers/directed/client";
import * as messages from "../messages";

// A graph-directed shape under the grid: as its picture, since nothing bends it state by state.

/** Pixels of the longer side, and of the margin that the bend pulls into. */
const SIDE = 1440;
const MARGIN = 48;

/** Draws the shape of the present moment, complete, and takes that under the grid. */
async function bendItsPicture(): Promise<void> {
  const moment = directedMoment.peek();
  if (!moment) return;
  const box = directedBoxAt.peek()?.(moment.t) ?? { x0: 0, y0: 0, x1: 1, y1: 1 };
  const [across, up] = [box.x1 - box.x0, box.y1 - box.y0].map((side) => Math.max(side, 1e-12)) as [
    number,
    number,
  ];
  const scale = (SIDE - 2 * MARGIN) / Math.max(across, up);
  const width = Math.round(across * scale) + 2 * MARGIN;
  const height = Math.round(up * scale) + 2 * MARGIN;
  const insets = { top: MARGIN, right: MARGIN, bottom: MARGIN, left: MARGIN };
  const view = fitFor(box, { width, height }, insets);
  const { colouring } = scene.peek();
  const look = directedLook(colouring, pieceColours(dark.peek() ? "dark" : "light"));
  try {
    const pixels = await directedTask("pixels", { moment, options: { width, height, view, ...look } });
    const { a, b } = endsOf(scene.peek());
    bendPicture({ pixels, width, height, name: moment.t < 0.5 ? a.name : b.name });
  } catch (problem) {
    notify({ kind: "error", text: messages.notDrawn(wordsOf(problem)) });
  }
}

/** Why a graph-directed shape is not bent, and what can be done. */
export function Unbent() {
  return (
    <div class="panel">
      <section class="stack" aria-labelledby="unbent">
        <header class="section-head">
          <h2 id="unbent">{messages.thisShapeNotDeformed}</h2>
        </header>
        <p>{messages.hasSeveralStatesDeformation}</p>
        <div class="row">
          <Button kind="primary" icon="grid" onClick={() => void bendItsPicture()}>
            {messages.deformPicture}
          </Button>
          <Button icon="back" onClick={() => openTool("morph")}>
            {messages.backToMorph}
          </Button>
          <Button
            kind="quiet"
            onClick={() => {
              backToSystems();
              announce(messages.backToSystemsMaps);
            }}
          >
            {messages.deformSystemMapsInstead}
          </Button>
        </div>
      </section>
      <PanelFoot />
    </div>
  );
}

/** The grid stays under the hand that has bent it, as long as it is seen. */
import { scene } from "#document/scene";
import type { Box } from "#geometry/boxes";
import { afterDrag, FOOT, fitOnStage, stageSize } from "#stage/view";

/** What is nearer to the edge of the stage than this, in pixels, has left it. */
const EDGE = 12;
/** What has become smaller than this part of what is fitted is fitted anew. */
const SMALLEST = 0.5;

const sizeOf = ({ x0, y0, x1, y1 }: Box) => Math.max(x1 - x0, y1 - y0);

/** Whether all of a box is seen where another one is fitted, and not too small. */
export function seenIn(fit: Box, box: Box): boolean {
  const { width, height } = stageSize.peek();
  const { x, y, scale } = fitOnStage(fit);
  const [across, up] = [(width / 2 - EDGE) / scale, (height / 2 - EDGE) / scale];
  const low = y - up + (FOOT - EDGE) / scale;
  const inside = box.x0 >= x - across && box.x1 <= x + across && box.y0 >= low && box.y1 <= y + up;
  return inside && sizeOf(box) > SMALLEST * sizeOf(fit);
}

afterDrag.keeps = (fit, box) => scene.peek().tool === "deform" && seenIn(fit, box);

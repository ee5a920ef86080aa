/** Which part of the plane a frame of a film shows, or a picture of a size of its own. */
import { fitFor } from "#document/framing";
import type { Box } from "#geometry/boxes";
import type { Size, View } from "#geometry/coordinates";
import { stageSize, view } from "./view";

/** Free on each side, as a part of the shorter one. */
const MARGIN = 0.06;

/** What the stage shows, larger or smaller; where nobody has zoomed, all of a box. */
export function frameView(box: Box, size: Size): View {
  const zoomed = view.peek();
  if (zoomed) {
    const stage = stageSize.peek();
    const larger = Math.min(size.width / Math.max(1, stage.width), size.height / Math.max(1, stage.height));
    return { ...zoomed, scale: zoomed.scale * larger };
  }
  const edge = MARGIN * Math.min(size.width, size.height);
  return fitFor(box, size, { top: edge, right: edge, bottom: edge, left: edge });
}

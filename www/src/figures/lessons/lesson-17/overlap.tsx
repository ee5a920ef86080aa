import { useMemo, useState } from "preact/hooks";
import type { Box } from "#document/framing";
import { fixed } from "#format/numbers";
import { Switch } from "#ui/controls/Switch";
import layout from "../../kit/frame/layout.module.css";
import { Picture } from "../../kit/picture/picture";
import lessonCss from "../frame/lesson.module.css";
import { GRIDDED, moran, REPEATED } from "./boxes";

const UNIT: Box = { x0: 0, y0: 0, x1: 1, y1: 1 };

/** A shape for which Moran's equation says too much: one of its pieces lies on another. */
export function TooMuch() {
  const [added, setAdded] = useState(false);
  const maps = useMemo(() => [...(added ? REPEATED : GRIDDED.gasket.maps)], [added]);
  const said = moran(maps.map(([a]) => a));
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <div>
        <Picture
          maps={maps}
          box={UNIT}
          label={
            added
              ? "The gasket, one part of its first piece in a fourth colour: the piece of map 4 lies on it."
              : "The gasket of three maps."
          }
        />
      </div>
      <div class={lessonCss["ask"]}>
        <p>
          The equation knows only the scales, and not where the pieces lie. Add a fourth map of scale ¼ that
          lays its piece onto a part of piece 1 which is there already.
        </p>
        <Switch checked={added} onChange={setAdded}>
          Add the fourth map
        </Switch>
        <p class="number" aria-live="polite">
          Moran’s equation: {fixed(said, 3)}.{" "}
          {added
            ? "But the shape is the gasket as before, and so are its boxes: its dimension is still 1.585. Pieces overlap, so the equation gives only an upper bound."
            : "That is the dimension: the pieces meet in single points."}
        </p>
      </div>
    </div>
  );
}

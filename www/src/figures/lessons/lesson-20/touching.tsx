import { useEffect, useState } from "preact/hooks";
import type { Uv } from "#geometry/path";
import { Button } from "#ui/controls/Button";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { PointControls } from "../../kit/frame/point-controls";
import { point } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Chart } from "./chart";
import { Here, usePlace } from "./here";
import { markOf, type Touch, touched } from "./map";
import css from "./page.module.css";

const FIRST: Uv = [0, 0.5];

/** An empty map: each touch shows a shape, and leaves a mark. */
export function Touching() {
  const [at, setAt] = useKept<Uv>("place", FIRST, point(-1, 2));
  const [touches, setTouches] = useState<readonly Touch[]>([]);
  const place = usePlace(at);
  const mark = place.answer && markOf(place.answer);
  useEffect(() => {
    if (mark) setTouches((before) => touched(before, { at, mark }));
  }, [mark, at]);
  return (
    <>
      <div class={css["map-and-shape"]}>
        <Panel caption="Each touch leaves a mark: one disc where the shape is whole, two halves where it is in pieces.">
          <Chart field={null} label={null} touches={touches} point={at} onMove={setAt} />
        </Panel>
        <Panel>
          <Here at={at} of={place} />
        </Panel>
      </div>
      <Coordinates at={at} onMove={setAt} />
      <div class={layout["buttons"]}>
        <Button onClick={() => setTouches([])}>Rub out the marks</Button>
      </div>
    </>
  );
}

interface CoordinatesProps {
  at: Uv;
  onMove: (at: Uv) => void;
  step?: number;
}

/** Both numbers of a place. */
export function Coordinates({ at, onMove, step = 0.05 }: CoordinatesProps) {
  return (
    <div class={layout["controls"]}>
      <PointControls
        point={at}
        axes={[
          { label: "turn and stretch", symbol: "u" },
          { label: "move", symbol: "v" },
        ]}
        range={[-1, 2]}
        step={step}
        onMove={onMove}
      />
    </div>
  );
}

import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import type { MapRow3 } from "#wasm/api";
import { SpacePicture } from "../../darwish/space/space-picture";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import tableCss from "../../kit/frame/table.module.css";
import lessonCss from "../frame/lesson.module.css";
import { viewOf } from "../lesson-24/shapes";

const EYE = { turn: 20, tilt: 24 };

interface TurningProps {
  degrees: number;
  onDegrees: (degrees: number) => void;
  maps: MapRow3[];
  /** Whether the numbers of one map are shown beside it. */
  numbers?: boolean;
}

/** A shape with the maps that it is made of, and what turns them. */
export function Turning({ degrees, onDegrees, maps, numbers = false }: TurningProps) {
  const objects = useMemo(() => [{ maps }], [maps]);
  const view = useMemo(() => viewOf(EYE), []);
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <SpacePicture
        objects={objects}
        view={view}
        label={`A tetrahedron of four half-size copies of itself, its maps turned by ${degrees} degrees.`}
      />
      <div class={lessonCss["ask"]}>
        <SliderControl
          label="turn of the maps"
          symbol="T"
          range={[0, 360]}
          whole
          value={degrees}
          text={`${degrees}°`}
          valueText={`${degrees} degrees`}
          onChange={onDegrees}
        />
        {numbers && <Numbers map={maps[1]} />}
      </div>
    </div>
  );
}

/** The twelve numbers of a map. */
function Numbers({ map }: { map: MapRow3 | undefined }) {
  if (!map) return null;
  return (
    <table class={tableCss["measurements"]}>
      <caption>The second map</caption>
      <thead>
        <tr>
          <th scope="colgroup" colSpan={3}>
            matrix
          </th>
          <th scope="col">shift</th>
        </tr>
      </thead>
      <tbody>
        {[0, 1, 2].map((row) => (
          <tr key={row}>
            {[...map.slice(3 * row, 3 * row + 3), map[9 + row] ?? 0].map((x, i) => (
              <td key={`${i + 1}`} class="number">
                {fixed(Math.abs(x) < 5e-4 ? 0 : x, 3)}
              </td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

import { useMemo } from "preact/hooks";
import { fixed, formatNumber } from "#format/numbers";
import { about3, turns3 } from "#geometry/maps/affine3";
import { Button } from "#ui/controls/Button";
import mapBlocksCss from "#ui/shapes/map-blocks.module.css";
import type { SpaceView } from "#wasm/api";
import { loadSpace } from "#wasm/space";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { optional } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { VIEW } from "../space/eye";
import { LookAgain } from "../space/look-again";
import { MIDDLE, Scenery, useScene } from "../space/scenery";
import { inSpaceTool } from "../space/tool-link";
import { ANGLES, AngleSliders, type Angles, inRadians } from "../space/turning";
import css from "./page.module.css";
import {
  FIGURE_VII,
  FIGURE_VIII,
  farthest,
  farthestOfSecond,
  type Matrix3,
  SECOND_VII,
  SECOND_VIII,
  TURN,
  turned,
} from "./printed-matrices";

const START: Angles = [0, 0, 50];
const NONE: Angles = [0, 0, 0];

/** What stands in its address. */
export const STATE = {
  angles: kept(START, ANGLES),
  view: kept<SpaceView | null>(null, optional(VIEW)),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** The scene of Figure vii turned, by the parameters of every object in it. */
export function Page(heading: Heading) {
  const { made, count: maps, home } = useScene();
  const [angles, setAngles] = useKept("angles", ...STATE.angles);
  const [seen, setView] = useKept("view", ...STATE.view);
  const view = seen ?? home;
  const by = useMemo(() => about3(turns3(inRadians(angles)), [...MIDDLE]), [angles]);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The eye stays at the origin, and the world turns. One transform T is applied to the parameters of
          all {made.length} objects, {maps} conjugations in all, and every one of them is drawn from its new
          parameters. Turn it about the upright axis to walk around it without a step.
        </p>
      }
      found={
        <>
          <p>
            A scene is the union of its objects, and T of a union is the union of the parts: what holds for
            one set of parameters holds for a list of them. In the Space tool the same is done at the moments
            of a time line, and each frame of a film is the list that comes of it.
          </p>
          <p>One matrix of the paper’s scene is printed whole, under Figure viii:</p>
          <Printed label="Fig viii" rows={FIGURE_VIII} />
          <p>
            It shrinks a plane to 0.54 and flattens what is across it, so that it is a map of something flat.
            Of its translation 25.59 is left. Of the map beside it the first two numbers of each row can be
            read, {SECOND_VIII.map(([a, b]) => `(${minus(a)}, ${minus(b)})`).join(", ")}, then 0.36, and 7.02
            of its translation. That is too little to draw.
          </p>
          <Printed label="Fig vii" rows={FIGURE_VII} />
          <p>
            These nine stand under Figure vii; the sixth is cut off after its first decimal. They look like
            the same map before it was turned: a turn by {TURN.degrees}° about ({TURN.axis.join(", ")}) brings
            them onto the matrix above by eq 1, with no number off by more than{" "}
            {formatNumber(farthest(turned(FIGURE_VII, TURN), FIGURE_VIII), 4)}, which is the rounding of the
            print. Turns from some 150° to 170° about axes nearby do about as well, so that the paper’s own
            cannot be told.
          </p>
          <p>
            Behind them stand 1.09, the third translation of this map, and ({SECOND_VII.map(minus).join(", ")}
            ) with −1.64, the last row of a second map. The same turn fits these as well: by eq 1 it takes
            this row to what the two columns above give, to {formatNumber(farthestOfSecond(), 4)}.
          </p>
        </>
      }
      parameters={[
        ...(["x", "y", "z"] as const).map((axis, k) => ({
          name: `Turned about ${axis}`,
          value: `${angles[k] ?? 0}°`,
        })),
        {
          name: "What stays",
          value: `(${MIDDLE.map((x) => formatNumber(x)).join(", ")}), the middle of the scene`,
        },
        { name: "Conjugations", value: String(maps) },
      ]}
      captions={["Fig viii Rotation of vii"]}
      own
      reconstructed="The scene and its maps were made here, as in Figure vii, and the angles are chosen here: the paper prints none. What can be read of two maps is shown on this page; no shape here is drawn with it."
      studio={inSpaceTool(
        made.map((object) => ({ ...object, moved: by })),
        home,
      )}
    >
      <Scenery
        made={made}
        by={by}
        view={view}
        onView={setView}
        label={`The natural scene turned by ${angles.join(", ")} degrees about x, y and z`}
      />
      <AngleSliders angles={angles} onChange={setAngles} />
      <div class={layout["buttons"]}>
        <Button kind="quiet" icon="reset" disabled={angles === NONE} onClick={() => setAngles(NONE)}>
          As in Figure vii
        </Button>
        <LookAgain view={view} home={home} onView={setView} />
      </div>
    </Frame>
  );
}

const minus = (x: number) => fixed(x, 2).replace("-", "−");

/** Nine numbers as they stand in print. */
function Printed({ label, rows }: { label: string; rows: Matrix3 }) {
  return (
    <table class={`${mapBlocksCss["map-block"]} ${css["printed"]}`} style={{ "--digits": "2" }}>
      <caption>{label}</caption>
      <tbody>
        {rows.map((row, i) => (
          <tr key={i}>
            {row.map((value, k) => (
              <td key={k}>{fixed(value, 2)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

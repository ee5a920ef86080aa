import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { after3, shift3, turns3 } from "#geometry/maps/affine3";
import { loadSpace } from "#wasm/space";
import { SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { number } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { fromOrigin, VIEW } from "../space/eye";
import { LookAgain } from "../space/look-again";
import { triangle } from "../space/shapes";
import { inSpaceTool } from "../space/tool-link";
import { THAT_OF_FIGURE_I } from "../space/triangle";
import { ANGLES, AngleSliders, type Angles, Conjugated, inRadians } from "../space/turning";

const ANGLE = 0.045;
/** How far it is carried along x and along y, and how it is turned: so that the table shows what is printed. */
const PRINTED = 30.5;
export const BESIDE = -0.3;
const TURNED: Angles = [-28, 21, 154];

/** What stands in its address. */
export const STATE = {
  angles: kept(TURNED, ANGLES),
  away: kept(PRINTED, number(20, 90, 1)),
  view: kept(fromOrigin([PRINTED, BESIDE, 0], ANGLE), VIEW),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** The triangle far before the eye, which is at the origin. */
export function Page(heading: Heading) {
  const [angles, setAngles] = useKept("angles", ...STATE.angles);
  const [away, setAway] = useKept("away", ...STATE.away);
  const [view, setView] = useKept("view", ...STATE.view);
  const made = useMemo(() => triangle("halves"), []);
  const by = useMemo(() => after3(shift3([away, BESIDE, 0]), turns3(inRadians(angles))), [angles, away]);
  const home = fromOrigin([away, BESIDE, 0], ANGLE);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          In the paper the eye never moves: it sits at the origin and looks along x. To be seen, a shape has
          to be carried before it, and that, too, is done to the parameters. The first translations in the
          print are 14.99 and 15.33: as the maps are halves, their corners are twice as far away, at about 30.
          The page begins there.
        </p>
      }
      found={
        <p>
          A translation b alone does not say where a map stands. Where its own corner p stays fixed, b = (I −
          A) p, so that a half about a corner 30 units away has a translation of 15. Nearer, the picture
          grows; at 0 the eye is in the middle of it, and the perspective has nothing to hold on to.
        </p>
      }
      parameters={[
        ...(["x", "y", "z"] as const).map((axis, k) => ({
          name: `Turned about ${axis}`,
          value: `${fixed(angles[k] ?? 0, 0)}°`,
        })),
        { name: "Carried along x", value: fixed(away, 1) },
        { name: "Carried along y", value: fixed(BESIDE, 1) },
        { name: "Eye", value: "(0, 0, 0), looking along x" },
        { name: "Height of the picture", value: `${fixed((ANGLE * 180) / Math.PI, 1)}°` },
      ]}
      captions={["Fig iii (After more rotations)"]}
      reconstructed={`Printed are the matrices, 0.50 on the diagonal and ±0.00 beside it (one looks like −0.90), and four numbers of the translations: 14.99 and −0.08 of the first map, 15.33 of the second, −0.45 of the third. The angles and the move are not printed: these bring out all four. ${THAT_OF_FIGURE_I}`}
      studio={inSpaceTool([{ name: "Triangle", maps: made, moved: by }], view)}
    >
      <Conjugated
        made={made}
        by={by}
        view={view}
        onView={setView}
        label={`The triangle ${fixed(away, 1)} units before the eye`}
      >
        <AngleSliders angles={angles} onChange={setAngles} />
        <div class={layout["controls"]}>
          <SliderControl
            label="carried along x"
            range={[20, 90]}
            step={1}
            value={away}
            text={fixed(away, 1)}
            valueText={`${fixed(away, 1)} units before the eye`}
            onChange={(next) => setAway(Math.round(10 * next) / 10)}
          />
          <LookAgain view={view} home={home} onView={setView} />
        </div>
      </Conjugated>
    </Frame>
  );
}

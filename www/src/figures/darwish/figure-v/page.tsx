import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { scale3, shift3 } from "#geometry/maps/affine3";
import { Button } from "#ui/controls/Button";
import { loadSpace } from "#wasm/space";
import { SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { tex } from "../../kit/notation/tex";
import { number } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { fromOrigin, VIEW } from "../space/eye";
import { LookAgain } from "../space/look-again";
import { PYRAMID_ANGLE, PYRAMID_AWAY, pyramid, pyramidMiddle } from "../space/shapes";
import { inSpaceTool } from "../space/tool-link";
import { Conjugated } from "../space/turning";

const STILL = scale3([1, 1, 1]);

/** What stands in its address. */
export const STATE = {
  away: kept(PYRAMID_AWAY, number(12, 40, 1)),
  view: kept(fromOrigin(pyramidMiddle(PYRAMID_AWAY), PYRAMID_ANGLE), VIEW),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** Five halves, as far before the eye as one likes. */
export function Page(heading: Heading) {
  const [away, setAway] = useKept("away", ...STATE.away);
  const [view, setView] = useKept("view", ...STATE.view);
  const made = useMemo(() => pyramid(pyramidMiddle(PYRAMID_AWAY)), []);
  const by = useMemo(() => (away === PYRAMID_AWAY ? STILL : shift3([away - PYRAMID_AWAY, 0, 0])), [away]);
  const home = fromOrigin(pyramidMiddle(away), PYRAMID_ANGLE);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Five maps that halve everything: towards the four corners of a base, and towards the tip. The eye is
          at the origin, the pyramid {fixed(away, 1)} units before it. Carry it nearer or farther: its
          matrices stay, and all that changes is the first of each map’s three translations.
        </p>
      }
      found={
        <p>
          Its dimension is ln 5 / ln 2 = 2.322, more than a surface and less than a solid, although its base
          is a filled square and its four sides are Sierpinski’s triangles. In the print the first translation
          is 15.0; for a half that puts the corner at 30.
        </p>
      }
      parameters={[
        { name: "Maps", symbol: "N", value: "5" },
        { name: "Matrix of each", symbol: "A", value: [tex`\operatorname{diag}(0.5, 0.5, 0.5)`] },
        { name: "Base", value: "0.8 by 0.8 units, 0.8 below the tip" },
        { name: "Distance of its middle", value: fixed(away, 1) },
        { name: "Eye", value: "(0, 0, 0), looking along x" },
        { name: "Height of the picture", value: `${fixed((PYRAMID_ANGLE * 180) / Math.PI, 1)}°` },
      ]}
      captions={["Fig v a Fractal pyramid"]}
      reconstructed="The paper prints the parameters to one decimal, and the scan cuts them off. 0.5 I can be read, 15.0 as the first translation of the first map, and 0.3 in two places that cannot be told. The distance and the base are chosen so that these numbers come out; the rest of the corners is Frond’s own."
      studio={inSpaceTool([{ name: "Pyramid", maps: made, moved: by }], view)}
    >
      <Conjugated
        wide
        digits={1}
        made={made}
        by={by}
        view={view}
        onView={setView}
        label={`A fractal pyramid, ${fixed(away, 1)} units before the eye`}
      >
        <div class={layout["controls"]}>
          <SliderControl
            label="distance"
            name="Distance from the eye"
            range={[12, 40]}
            step={0.5}
            value={away}
            text={fixed(away, 1)}
            valueText={`${fixed(away, 1)} units`}
            onChange={(next) => setAway(Math.round(10 * next) / 10)}
          />
          <div class={layout["buttons"]}>
            <Button onClick={() => setAway(PYRAMID_AWAY)} pressed={away === PYRAMID_AWAY}>
              As in print
            </Button>
            <Button onClick={() => setAway(15)} pressed={away === 15}>
              From half as far: 15
            </Button>
            <LookAgain view={view} home={home} onView={setView} />
          </div>
        </div>
      </Conjugated>
    </Frame>
  );
}

import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { about3, apply3, turns3 } from "#geometry/maps/affine3";
import { Button } from "#ui/controls/Button";
import { loadSpace } from "#wasm/space";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { tex } from "../../kit/notation/tex";
import { number, oneOf } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { fromOrigin, seen, VIEW } from "../space/eye";
import { LookAgain } from "../space/look-again";
import { PYRAMID_ANGLE, PYRAMID_AWAY, pyramid, pyramidMiddle } from "../space/shapes";
import spaceCss from "../space/space.module.css";
import { inSpaceTool } from "../space/tool-link";
import { ANGLES, AngleSliders, type Angles, Conjugated, inRadians } from "../space/turning";

/** So that the first translations are those that can be read in print. */
const START: Angles = [0, -45, -20];

/** What stands in its address. */
export const STATE = {
  angles: kept(START, ANGLES),
  about: kept<"itself" | "eye">("itself", oneOf(["itself", "eye"])),
  away: kept(PYRAMID_AWAY, number(12, 40, 1)),
  view: kept(fromOrigin(pyramidMiddle(PYRAMID_AWAY), PYRAMID_ANGLE), VIEW),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** The pyramid turned, about itself or about the eye. */
export function Page(heading: Heading) {
  const [angles, setAngles] = useKept("angles", ...STATE.angles);
  const [about, setAbout] = useKept("about", ...STATE.about);
  const [away, setAway] = useKept("away", ...STATE.away);
  const [view, setView] = useKept("view", ...STATE.view);
  const middle = useMemo(() => pyramidMiddle(away), [away]);
  const home = fromOrigin(middle, PYRAMID_ANGLE);
  const made = useMemo(() => pyramid(middle), [middle]);
  const by = useMemo(() => {
    const turn = turns3(inRadians(angles));
    return about === "itself" ? about3(turn, middle) : turn;
  }, [angles, about, middle]);
  const [x, y, depth] = seen(view)(apply3(by, middle));
  const behind = depth < 0;
  const gone = behind || Math.abs(x) > 2.5 || Math.abs(y) > 1.6;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The pyramid of Figure v, turned. About itself, the eye sees another side of it. About the origin it
          is swung around the eye instead: a few degrees, and it leaves the picture. Both are eq 1; they
          differ in the translation of T alone.
        </p>
      }
      found={
        <p>
          To turn about a point c is to move c to the origin, to turn, and to move it back, all in one T. The
          matrices of the maps come out the same both ways, and as they are halves, they do not change at all.
        </p>
      }
      parameters={[
        ...(["x", "y", "z"] as const).map((axis, k) => ({
          name: `Turned about ${axis}`,
          value: `${fixed(angles[k] ?? 0, 0)}°`,
        })),
        {
          name: "What stays",
          value: about === "itself" ? `(${middle.join(", ")}), its middle` : "(0, 0, 0), the eye",
        },
        { name: "Distance of its middle", value: fixed(away, 1) },
        { name: "Matrix of each map", symbol: "A", value: [tex`\operatorname{diag}(0.5, 0.5, 0.5)`] },
      ]}
      captions={["Fig vi Rotation of v"]}
      reconstructed="The scan cuts the parameters off. 0.5 I can be read, and the first translations of four maps, 15.1, 15.3, 15.4 and 15.5: so it was turned about itself. The angles are not printed: these bring out all four. The pyramid is that of Figure v, whose corners are reconstructed. Numbers of 0.1 and 0.0 are left of other rows, in places that cannot be told."
      studio={inSpaceTool([{ name: "Pyramid", maps: made, moved: by }], view)}
    >
      <div class={layout["buttons"]}>
        <Choice
          label="Turned about"
          name="What it is turned about"
          value={about}
          options={[
            { value: "itself", label: "itself" },
            { value: "eye", label: "the eye" },
          ]}
          onChange={setAbout}
        />
        <Button kind="quiet" icon="reset" onClick={() => setAngles([0, 0, 0])}>
          As in Figure v
        </Button>
        <LookAgain view={view} home={home} onView={setView} />
      </div>
      <Conjugated
        wide
        digits={1}
        made={made}
        by={by}
        view={view}
        onView={setView}
        label={`The pyramid turned by ${angles.join(", ")} degrees about ${about}`}
      >
        <p class={spaceCss["space-note"]} role="status">
          {gone
            ? behind
              ? "The pyramid is behind the eye: there is nothing to be seen."
              : "The pyramid is beside the picture: drag to look for it."
            : "The pyramid is before the eye."}
        </p>
        <AngleSliders angles={angles} onChange={setAngles} />
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
          </div>
        </div>
      </Conjugated>
    </Frame>
  );
}

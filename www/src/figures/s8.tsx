import { useMemo, useState } from "preact/hooks";
import { about3, turns3 } from "../engine/space/affine";
import { Button } from "../ui/Button";
import { formatNumber } from "../ui/number";
import { Frame, type Heading } from "./frame";
import { looksAway, useScene } from "./s7";
import { MIDDLE, Scenery } from "./scenery";
import { inSpace, spaceHref } from "./solid";
import { AngleSliders, type Angles, inRadians } from "./turning";

const START: Angles = [0, 0, 50];
const NONE: Angles = [0, 0, 0];

/** The scene of Figure vii turned, by the parameters of every object in it. */
function Page(heading: Heading) {
  const { made, home } = useScene();
  const [angles, setAngles] = useState(START);
  const [view, setView] = useState(home);
  const by = useMemo(() => about3(turns3(inRadians(angles)), [...MIDDLE]), [angles]);
  const maps = made.reduce((sum, object) => sum + object.maps.length, 0);
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
        <p>
          A scene is the union of its objects, and T of a union is the union of the parts: what holds for one
          set of parameters holds for a list of them. In the Space tool the same is done at the moments of a
          time line, and each frame of a film is the list that comes of it.
        </p>
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
      reconstructed="The angles are not printed, and the scene is Frond’s own, as in Figure vii."
      studio={{
        href: spaceHref(
          made.map((object) => ({ ...object, moved: by })),
          home,
        ),
        label: "Open in the Space tool",
      }}
    >
      <Scenery
        made={made}
        by={by}
        view={view}
        onView={setView}
        label={`The natural scene turned by ${angles.join(", ")} degrees about x, y and z`}
      />
      <AngleSliders angles={angles} onChange={setAngles} />
      <div class="buttons">
        <Button kind="quiet" icon="reset" disabled={angles === NONE} onClick={() => setAngles(NONE)}>
          As in Figure vii
        </Button>
        <Button kind="quiet" icon="reset" disabled={!looksAway(view, home)} onClick={() => setView(home)}>
          Look along x again
        </Button>
      </div>
    </Frame>
  );
}

export const Space8 = inSpace(Page);

import { formatNumber } from "#format/numbers";
import { scale3 } from "#geometry/maps/affine3";
import type { SpaceView } from "#wasm/api";
import { loadSpace } from "#wasm/space";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { optional } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { VIEW } from "../space/eye";
import { LookAgain } from "../space/look-again";
import { Scenery, useScene } from "../space/scenery";
import { inSpaceTool } from "../space/tool-link";

const STILL = scale3([1, 1, 1]);

/** What stands in its address. */
export const STATE = {
  view: kept<SpaceView | null>(null, optional(VIEW)),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** Ground, trees, ferns and clouds from the origin. */
export function Page(heading: Heading) {
  const { made, count: maps, home } = useScene();
  const [turned, setView] = useKept("view", ...STATE.view);
  const view = turned ?? home;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A landscape of {made.length} objects. Each is an attractor with a set of parameters of its own: the
          ground, the trees on it, two ferns, and two clouds above. Nothing else is stored, no point and no
          triangle, and every frame of a film is such a list of numbers. Drag to look around from where you
          stand.
        </p>
      }
      found={
        <p>
          All of it takes {maps} maps, {formatNumber(12 * maps)} numbers. The trees are one shape in three
          places, and so are the clouds in two: to place a copy is to conjugate its maps once, by eq 1, so
          that copies share a kind and differ in their numbers.
        </p>
      }
      parameters={[
        ...made.map(({ name, maps: own }) => ({
          name,
          value: `${own.length} maps, ${12 * own.length} numbers`,
        })),
        { name: "Eye", value: "(0, 0, 0), looking along x" },
        { name: "Height of the picture", value: `${formatNumber((home.angle * 180) / Math.PI, 1)}°` },
      ]}
      captions={["Fig vii a natural scene"]}
      own
      reconstructed="The maps of this scene were made here: of the paper’s, the print shows nine numbers that look like the matrix of one map, the last digit of one cut off, with 1.09 as its third translation, and the last row of another, 0.05, −0.42, 0.34 with −1.64; its picture is hard to make out. That a scene has several objects and is seen from the origin is the paper’s. Figure viii shows what can be read."
      studio={inSpaceTool(made, home)}
    >
      <Scenery
        made={made}
        by={STILL}
        view={view}
        onView={setView}
        label="A natural scene: hills with trees and ferns under two clouds"
      />
      <div class={layout["buttons"]}>
        <LookAgain view={view} home={home} onView={setView} />
      </div>
    </Frame>
  );
}

import { useMemo } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { formatNumber } from "#format/numbers";
import { axisWords, divergingWords, unit } from "#format/placement";
import { ShadowPicture } from "#stage/ShadowPicture";
import { Segmented } from "#ui/controls/Segmented";
import { FlattenedMaps } from "#ui/shapes/FlattenedMaps";
import type { EpsilonProjection, MapRow3, Point3, SpaceView } from "#wasm/api";
import { loadSpace, solid } from "#wasm/space";
import { SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { number, oneOf, optional } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { fromOrigin, orbited, VIEW } from "../space/eye";
import spaceCss from "../space/space.module.css";
import { SpaceDots } from "../space/space-dots";
import { inSpaceTool, presetMaps } from "../space/tool-link";

const SHAPES = [
  { value: "fern", label: "Fern" },
  { value: "sponge", label: "Sponge" },
  { value: "dragon", label: "Dragon" },
] as const;
type Name = (typeof SHAPES)[number]["value"];

const DIRECTIONS: Record<string, Point3> = {
  x: [1, 0, 0],
  y: [0, 1, 0],
  z: [0, 0, 1],
  aslant: unit([1, 2, -1]) ?? [1, 0, 0],
};

/** What is thinner cannot be told from a sheet, on paper or on a screen. */
const LEAST_EXPONENT = -6;
const MAPS_SHOWN = 4;

function flattened(maps: MapRow3[], direction: Point3, epsilon: number): EpsilonProjection | { why: string } {
  try {
    return solid.epsilonProjection(maps, direction, epsilon, { frame: "space" });
  } catch (problem) {
    return { why: wordsOf(problem) };
  }
}

function exactCount(maps: MapRow3[], direction: Point3): number | null {
  try {
    return solid.projectExactly(maps, direction).length;
  } catch {
    return null;
  }
}

/** Beside the line of sight, so that the thickness is seen, around a shape. */
function sideView(maps: MapRow3[], direction: Point3): SpaceView | null {
  try {
    const { centre, radius } = solid.facts3(maps);
    const { turn, tilt } = fromOrigin(direction, 1);
    return orbited({ target: centre, distance: 3.6 * radius, turn, tilt, angle: 0.55 }, 0.5, 0.28);
  } catch {
    return null;
  }
}

/** What stands in its address. */
export const STATE = {
  shape: kept<Name>("fern", oneOf(SHAPES.map(({ value }) => value))),
  way: kept("y", oneOf(Object.keys(DIRECTIONS))),
  thickness: kept(-0.5, number(LEAST_EXPONENT, 0, 1)),
  view: kept<SpaceView | null>(null, optional(VIEW)),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** Section 3.5: a projection as the limit of flattening. */
export function Page(heading: Heading) {
  const [shape, setShape] = useKept("shape", ...STATE.shape);
  const [way, setWay] = useKept("way", ...STATE.way);
  const [power, setPower] = useKept("thickness", ...STATE.thickness);
  const maps = useMemo(() => presetMaps(shape), [shape]);
  const direction = DIRECTIONS[way] ?? [0, 1, 0];
  const epsilon = Number((10 ** power).toPrecision(2));
  const flat = useMemo(() => flattened(maps, direction, epsilon), [maps, direction, epsilon]);
  const exact = useMemo(() => exactCount(maps, direction), [maps, direction]);
  // The view is that of the shape before it is flattened, so that it is seen to become thin.
  const whole = useMemo(() => sideView(maps, direction), [maps, direction]);
  const [turned, setTurned] = useKept("view", ...STATE.view);
  const view = turned ?? whole;
  const shown = "why" in flat ? null : flat.maps;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          To throw a shadow, says section 3.5, scale the shape by a very small ε along the line of sight: that
          is a transform like any other, and what is left is the shadow, coded by parameters. The picture
          agrees. The parameters do not: along z, the two upper numbers of the third column of each matrix are
          divided by ε, and as ε goes to 0 they grow without end. Along x and y it is the first and the second
          column.
        </p>
      }
      found={
        <p>
          {exact === null
            ? "From here some of these numbers are not 0, and the limit is no set of parameters at all. The shadow is there, but it need not be the attractor of any maps of the plane: where a point of the shadow goes hangs on how deep behind it the point of the shape lies."
            : `From here they all are 0: every map takes the line of sight to itself, and nothing grows. What is left, when the line of sight is dropped, are ${exact} maps of the plane whose attractor is the shadow, exactly. The Space tool takes such a shadow into the morph.`}
        </p>
      }
      parameters={[
        {
          name: "Shape",
          value: `${SHAPES.find(({ value }) => value === shape)?.label}, ${maps.length} maps`,
        },
        { name: "Line of sight", value: axisWords(direction) },
        { name: "Axes of the parameters", value: "those of the shape, as in the paper" },
        { name: "Thickness left", symbol: "ε", value: formatNumber(epsilon, 6) },
        {
          name: "Largest number",
          value: "why" in flat ? "–" : formatNumber(flat.largest, 3),
        },
        { name: "Numbers that grow as 1/ε", value: "why" in flat ? "–" : String(flat.diverging.length) },
      ]}
      captions={[
        "If we apply a scaling transform in a given direction say z making the scaling factor very small then the result is a planner fractal-with derived parameters- in the x-y plane.",
      ]}
      own
      reconstructed="The section has no figure: this one is made here, on shapes of Frond’s gallery."
      differs="The paper concludes that projections of IFS fractals are IFS fractals. That is so where the line of sight is kept by every map, and in the limit not elsewhere."
      studio={inSpaceTool([
        { preset: shape, name: SHAPES.find(({ value }) => value === shape)?.label ?? "", maps },
      ])}
    >
      <div class={layout["controls"]}>
        <div class={layout["buttons"]}>
          <Segmented
            label="Shape"
            value={shape}
            options={SHAPES}
            onChange={(next) => {
              setShape(next);
              setTurned(null);
            }}
          />
          <span class={layout["choice-label"]}>seen along</span>
          <Segmented
            label="Line of sight"
            value={way}
            options={Object.keys(DIRECTIONS).map((value) => ({ value, label: value }))}
            onChange={(next) => {
              setWay(next);
              setTurned(null);
            }}
          />
        </div>
      </div>
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Panel name="Flattened" words="from the side">
          {view && shown && (
            <SpaceDots
              maps={shown}
              view={view}
              onView={setTurned}
              points={60_000}
              label={`The shape flattened to ${formatNumber(epsilon, 6)} of its depth, seen from the side`}
            />
          )}
        </Panel>
        <Panel name="Its shadow" words="points, projected">
          <ShadowPicture maps={maps} direction={direction} points={150_000} />
        </Panel>
      </div>
      <SliderControl
        label="thickness left"
        name="Thickness left, ε"
        symbol="ε"
        range={[LEAST_EXPONENT, 0]}
        step={0.1}
        value={power}
        text={formatNumber(epsilon, 6)}
        valueText={formatNumber(epsilon, 6)}
        onChange={setPower}
      />
      {"why" in flat ? (
        <p class={spaceCss["space-note"]} role="status">
          {flat.why}
        </p>
      ) : (
        <div class={spaceCss["space-table"]}>
          <h2>Parameters of the flattened shape</h2>
          <p class={spaceCss["space-note"]} role="status">
            The largest number is <strong class="number">{formatNumber(flat.largest, 3)}</strong>.{" "}
            {divergingWords(flat.diverging)}
          </p>
          <FlattenedMaps of={flat} most={MAPS_SHOWN} />
          <p class={layout["choice-label"]}>
            {flat.maps.length > MAPS_SHOWN && `The first ${MAPS_SHOWN} of ${flat.maps.length} maps. `}
            In the axes of the shape, as in the paper: along z the scale is diag(1, 1, ε).
          </p>
        </div>
      )}
    </Frame>
  );
}

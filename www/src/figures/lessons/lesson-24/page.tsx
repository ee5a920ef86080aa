import { useMemo } from "preact/hooks";
import { loadSpace } from "#wasm/space";
import { SpacePicture } from "../../darwish/space/space-picture";
import { inSpaceTool, presetMaps } from "../../darwish/space/tool-link";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { tex } from "../../kit/notation/tex";
import { oneOf } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { type Choice, Choices, Reply } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { type Prediction, usePrediction } from "../frame/prediction";
import { Exercises } from "./exercises";
import { Shadow, ShadowPanel } from "./shadow";
import css from "./shadow.module.css";
import { EYE, type Eye, LYING, SPONGE, viewOf } from "./shapes";
import { TEACHING } from "./teaching";

type Guess = "gasket" | "cross" | "holes" | "full";
const TRUTH: Guess = "full";
const OPTIONS: readonly Choice<Guess>[] = [
  {
    value: "gasket",
    label: "A triangle full of triangular holes",
    wrong: "From above its four corners are those of a square. Where in that do the four copies lie?",
  },
  {
    value: "cross",
    label: "Two crossing lines, and dust around them",
    wrong: "The two lines are its lowest and its highest edge. But each copy has two such edges of its own.",
  },
  {
    value: "holes",
    label: "A square full of square holes",
    wrong: "Four squares of half the size lie in the four corners. How much of the whole is that?",
  },
  { value: "full", label: "A square without a hole" },
];
const FROM_THE_SIDE: Eye = { turn: 12, tilt: 16 };
const FROM_ABOVE: Eye = { turn: 0, tilt: 90 };

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** Shadows of shapes of space. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Guess>(null, oneOf(["gasket", "cross", "holes", "full"]));
  const [eye, setEye] = useKept<Eye>("eye", { turn: 6, tilt: 4 }, EYE);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Cut a cube into 27 small ones, take away the one in the middle and the six in the middles of the
            faces, and do the same with each of the 20 that are left, and so on without end. What remains is{" "}
            <em>Menger’s sponge</em>: 20 copies of itself, each a third as large.
          </p>
          <p>
            A lamp very far away shines on it. What you see is the sponge from the lamp, and beside it the
            shadow on a wall behind it: every point of the sponge, without its depth. Turn it. From straight
            in front the light comes through square windows; from elsewhere, does it come through at all?
          </p>
        </>
      }
      question={<Balancing prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        {
          name: "The sponge",
          value: [
            tex`f_i(x) = \frac{1}{3} x + \frac{2}{3} c_i`,
            ", the ",
            tex`c_i`,
            " being the 20 places of the cube from −1 to 1",
          ],
        },
        {
          name: "The tetrahedron",
          value: [tex`f_i(x) = \frac{1}{2} x + \frac{1}{2} c_i`, ", the ", tex`c_i`, " being its 4 corners"],
        },
        { name: "Their dimensions", value: "log 20 / log 3 = 2.727 and log 4 / log 2 = 2" },
        {
          name: "The shadow of a map",
          value: [tex`P(r x + t) = r P(x) + P(t)`, ", where ", tex`P`, " leaves out the depth"],
        },
      ]}
      sources={
        <>
          <p>
            Karl Menger described the sponge in 1926. That maps which shrink have one shape only that is made
            of its own images is a theorem of John Hutchinson (1981); the dimensions are those of Patrick
            Moran’s theorem (1946).
          </p>
          <p>
            Darwish and Abd-El-Wahab write that every shadow is made by maps again. It is where all maps keep
            the direction of the light; <a href="#figures/s35">their section 3.5</a> shows what happens
            elsewhere.
          </p>
        </>
      }
      studio={inSpaceTool([{ preset: "sponge", name: "Menger sponge", maps: presetMaps("sponge") }])}
    >
      <Shadow maps={SPONGE} name="Menger’s sponge" eye={eye} onEye={setEye} />
    </Lesson>
  );
}

function Balancing({ prediction }: { prediction: Prediction<Guess> }) {
  const { shown } = prediction;
  const objects = useMemo(() => [{ maps: LYING }], []);
  const view = useMemo(() => viewOf(FROM_THE_SIDE), []);
  return (
    <Question
      prediction={prediction}
      truth={TRUTH}
      beside={
        <div class={`${layout["two-columns"]} ${layout["even"]} ${css["square"]}`}>
          <Panel caption="From the side.">
            <SpacePicture
              objects={objects}
              view={view}
              label="Four half-size copies in the corners of a tetrahedron that balances on an edge"
            />
          </Panel>
          {shown ? (
            <ShadowPanel
              maps={LYING}
              eye={FROM_ABOVE}
              label="Its shadow on the table: a square of four squares, without a hole"
              caption="On the table."
            />
          ) : (
            <Panel caption="On the table.">
              <div class={css["covered"]} aria-hidden="true">
                ?
              </div>
            </Panel>
          )}
        </div>
      }
      answer={
        <Truth line="A square, and not a point of it is missing.">
          <Reply options={OPTIONS} prediction={prediction} truth={TRUTH} />
          <p>
            Four half-size copies make the tetrahedron, one in each corner. So four half-size copies of the
            shadow make the shadow, one in each of its corners; and seen from above these are the corners of a
            square. A square is made of four half-size squares just so, and one shape only can be made in this
            way. So it is the shadow.
          </p>
          <p>
            That holds whenever each map takes points on one ray of light to points on one ray: then the
            shadow of a copy is a copy of the shadow. Maps that only shrink, as <Formula tex={tex`r x + t`} />
            , do that for any light; maps that turn need not.
          </p>
          <p>
            The tetrahedron has no volume, but it has dimension 2, as the square has. More the shadow could
            not have: no shadow has a higher dimension than what throws it.
          </p>
        </Truth>
      }
      after={<Lit />}
    >
      <Choices<Guess>
        ask="Four half-size copies in the corners of a tetrahedron, each made of four again, without end. It balances on an edge, and the light comes straight from above. What is its shadow on the table?"
        options={OPTIONS}
        prediction={prediction}
        truth={TRUTH}
      />
    </Question>
  );
}

/** The same, lit from wherever one likes. */
function Lit() {
  const [eye, setEye] = useKept<Eye>("lamp", { turn: 0, tilt: 60 }, EYE);
  return <Shadow maps={LYING} name="the tetrahedron" eye={eye} onEye={setEye} />;
}

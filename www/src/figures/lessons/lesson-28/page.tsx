import { useMemo } from "preact/hooks";
import { loadSpace } from "#wasm/space";
import { inSpaceTool } from "../../darwish/space/tool-link";
import { tex } from "../../kit/notation/tex";
import { whole } from "../../kit/state/fields";
import {
  ChoiceQuestion,
  Formula,
  type Heading,
  Lesson,
  type Prediction,
  useChoice,
  useKept,
} from "../frame/parts";
import { Exercises } from "./exercises";
import { TEACHING } from "./teaching";
import { SHAPE, turnedMaps } from "./turned";
import { Turning } from "./turning";

type What = "matrix" | "shift" | "both";
const OPTIONS = [
  {
    value: "matrix",
    label: "Its matrix: the shape is turned, so the map turns as well",
    wrong:
      "A map that turns would turn each copy within the whole once more. Here the copies stand as the whole stands.",
  },
  { value: "shift", label: "Its shift alone: the matrix stays as it is" },
  {
    value: "both",
    label: "Both",
    wrong: "Look at the rows of the matrix below while you turn: do they change?",
  },
] as const;

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** A shape is turned by turning its maps. */
export function Page(heading: Heading) {
  const prediction = useChoice<What>(OPTIONS);
  const [degrees, setDegrees] = useKept("turn", 0, whole(0, 360));
  const maps = useMemo(() => turnedMaps(SHAPE, degrees), [degrees]);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            To turn a shape of space one could turn each of its points; of those there are infinitely many.
            But the shape is nothing but its maps. So turn the maps: take a point back to where it was, let
            the old map act there, and turn what comes of it: <Formula tex={tex`f_i' = T \, f_i \, T^{-1}`} />
            .
          </p>
          <p>
            Here are four maps, each of which halves everything towards a corner of a tetrahedron. The slider
            turns the maps, and nothing else; the picture is made of the new maps alone.
          </p>
        </>
      }
      question={<WhatChanges prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        {
          name: "Maps",
          value: [tex`f_i(x) = \frac{1}{2} x + \frac{1}{2} c_i`, ", towards its four corners"],
        },
        { name: "Turn", symbol: "T", value: `${degrees}° about the upright axis` },
        { name: "New maps", value: [tex`T \, f_i \, T^{-1}`] },
      ]}
      sources={
        <p>
          Darwish and Abd-El-Wahab animate shapes of space so (eq 1 of their paper):{" "}
          <a href="#figures/s2">Figure ii</a> turns a triangle of space. That the new maps have the turned
          shape follows from John Hutchinson’s theorem (1981): the turned shape is made of its images by the
          new maps, and there is only one such.
        </p>
      }
      studio={inSpaceTool([{ name: `Turned by ${degrees}°`, maps }])}
    >
      <Turning degrees={degrees} onDegrees={setDegrees} maps={maps} />
    </Lesson>
  );
}

function WhatChanges({ prediction }: { prediction: Prediction<What> }) {
  const [degrees, setDegrees] = useKept("asked", 0, whole(0, 360));
  const maps = useMemo(() => turnedMaps(SHAPE, degrees), [degrees]);
  return (
    <ChoiceQuestion<What>
      prediction={prediction}
      ask="Each of these maps has a matrix of nine numbers, which says how it turns and shrinks, and a shift of three. When the whole shape is turned, which of them have to change?"
      options={OPTIONS}
      truth="shift"
      after={<Turning numbers degrees={degrees} onDegrees={setDegrees} maps={maps} />}
      line="Its shift alone."
    >
      <p>
        The matrix of each map is one half of everything, and to halve is the same before a turn and after it:
        the turns <Formula tex={tex`T`} /> and <Formula tex={tex`T^{-1}`} /> around it cancel. What is left of
        the turn is where the map puts things: its shift is turned as a point is.
      </p>
      <p>
        A matrix that turns about another axis, or shrinks more in some direction across the axis, does not
        let a turn pass: then all twelve numbers may change.
      </p>
    </ChoiceQuestion>
  );
}

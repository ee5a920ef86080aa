import { fixed } from "#format/numbers";
import { studioHref } from "../../kit/frame/studio-link";
import { mapsOf } from "../../kit/locus/set-m";
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
import { Walk } from "./shape";
import { TEACHING } from "./teaching";
import { ASKED, FROM, onCircle, SHOWN, TO } from "./walk";

type Times = "never" | "once" | "thrice";
const OPTIONS = [
  {
    value: "never",
    label: "Never: on one circle all pieces are equally large",
    wrong:
      "They are equally large, but they are turned by another angle at every step, and so lie otherwise.",
  },
  {
    value: "once",
    label: "Once: from some angle on it is dust",
    wrong: "So it would be if the edge of M were smooth. Walk it below, step by step.",
  },
  { value: "thrice", label: "Three times: whole, dust, whole again, dust again" },
] as const;

/** The edge of M, met on a walk along a circle. */
export function Page(heading: Heading) {
  const prediction = useChoice<Times>(OPTIONS);
  const [degrees, setDegrees] = useKept("angle", 24, whole(0, 90));
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            The set <em>M</em> holds every complex number <Formula>s</Formula> whose shape of two pieces is in
            one piece. Below the size ½ there is nothing of it, and from 0.7071 on there is nothing else. Its
            edge lies between. What does it look like?
          </p>
          <p>
            Walk along a circle: the size of s stays at {SHOWN}, and only the angle changes, from no turn at
            all to a quarter turn. At every step you see the shape, and what is proved of it. Near the edge
            the verdict cannot be sure at times: then it says so.
          </p>
        </>
      }
      question={<HowOften prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        { name: "Maps", value: [tex`f_1(z) = s z - 1`, tex`f_2(z) = s z + 1`] },
        { name: "Size of s above", symbol: tex`\lvert s \rvert`, value: fixed(SHOWN) },
        { name: "Size of s in the question", symbol: tex`\lvert s \rvert`, value: fixed(ASKED) },
        { name: "Verdict", symbol: "ε", value: [tex`10^{-6}`, " of the size"] },
      ]}
      sources={
        <p>
          M is Michael Barnsley’s and Andrew Harrington’s (1985); that all is dust below ½, and in one piece
          from 0.7071 on, is theirs. Christoph Bandt (2002) and Danny Calegari, Sarah Koch and Alden Walker
          (2017) have studied its edge and its holes. What is said here of single numbers s is proved by
          Frond.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: `Angle ${degrees}°`, maps: mapsOf(onCircle(SHOWN, degrees)) },
          b: { name: "Twin-dragon", maps: mapsOf([0.5, 0.5]) },
        }),
      }}
    >
      <Walk size={SHOWN} degrees={degrees} onDegrees={setDegrees} />
    </Lesson>
  );
}

function HowOften({ prediction }: { prediction: Prediction<Times> }) {
  const [degrees, setDegrees] = useKept("asked", FROM, whole(FROM, TO));
  return (
    <ChoiceQuestion<Times>
      prediction={prediction}
      ask={`Now the circle of size ${ASKED}, a little farther out. At ${FROM}° the shape is proved in one piece, at ${TO}° it is proved dust. Going there degree by degree, how often does it change?`}
      options={OPTIONS}
      truth="thrice"
      after={<Walk size={ASKED} degrees={degrees} range={[FROM, TO]} onDegrees={setDegrees} />}
      line="Three times: in one piece to 68°, dust from 69° to 75°, in one piece again from 76° to 81°, and dust from there on."
    >
      <p>
        All of it is proved, degree by degree; what happens between two degrees nobody has looked at here. So
        the edge of M crosses this circle again and again: it runs in bays. Between two angles at which a
        shape hangs together there are others at which it does not, though all of these shapes are made of two
        equal pieces.
      </p>
    </ChoiceQuestion>
  );
}

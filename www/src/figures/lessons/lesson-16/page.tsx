import { useMemo } from "preact/hooks";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { HEIGHT } from "../../kit/maps/families";
import type { Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { Drawn, PieceNames } from "../../kit/picture/annotated";
import { useKept } from "../../kit/state/kept";
import { ChoiceQuestion } from "../frame/choice-question";
import { Lesson } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, useChoice } from "../frame/prediction";
import { firstDigits, pointOf } from "./address";
import { Exercises } from "./exercises";
import css from "./page.module.css";
import { ADDRESS, AddressField, BOX, MAPS, Mark, readOr, Seen } from "./seen";
import { TEACHING } from "./teaching";
import { middleOf, triangleOf } from "./view";
import { Zoom } from "./zoom";

/** Addresses. */
export function Page(heading: Heading) {
  const prediction = useChoice<Spot>(OPTIONS);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            Each piece of this shape has pieces in turn, so it has an address: 13 is piece 3 of piece 1, and
            132 is piece 2 of that. Every digit leads to a piece half as large.
          </p>
          <p>
            Type digits, or press a piece, and watch where they lead. For a single point the digits have to go
            on for ever: 1(2) means 1222…, with the part in brackets again and again.
          </p>
        </>
      }
      question={<Which prediction={prediction} />}
      exercises={<Exercises />}
      teaching={TEACHING}
      parameters={[
        {
          name: "Maps, towards the corners of a triangle of side 1",
          value: [tex`f_i(x) = \frac{1}{2} x + \frac{1}{2} c_i`],
        },
        {
          name: "Piece of an address",
          value: [tex`A_{i_1 i_2 \dots i_n} = f_{i_1}(f_{i_2}(\dots f_{i_n}(A)))`],
        },
        {
          name: "Point of an endless address",
          symbol: tex`i_1 i_2 \dots`,
          value: "the one point in all its pieces",
        },
      ]}
      sources={
        <p>
          John Hutchinson (1981): for maps that shrink, every row of digits without end is the address of
          exactly one point, and every point of the shape has one. Pieces that meet give the points that they
          share an address each. Fujimoto and others bend shapes by reading addresses the other way round:{" "}
          <a href="#figures/d1">their Figure 1</a>.
        </p>
      }
      studio={{ href: studioHref({ a: preset("gasket"), b: preset("koch") }) }}
    >
      <Typed />
    </Lesson>
  );
}

/** So many digits of an address without end are gone into. */
const DEEP = 9;

function Typed() {
  const [text, setText] = useKept("address", "13", ADDRESS);
  const address = readOr(text);
  const letters = useMemo(() => {
    const read = readOr(text);
    return read ? firstDigits(read, read.again.length > 0 ? DEEP : read.first.length) : [];
  }, [text]);
  const point = address && pointOf(MAPS, address);
  const size = letters.length === 0 ? "" : `, ${2 ** letters.length} times smaller than the whole`;
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Zoom
        letters={letters}
        label={`The piece of the first ${letters.length} digits with its three pieces in colour${size}.`}
        onPick={(letter) => !point && setText(`${text.trim()}${letter + 1}`)}
      >
        {(place) =>
          point ? (
            <Mark place={place} at={point} kind="target" />
          ) : (
            <PieceNames at={[0, 1, 2].map((letter) => place(middleOf(triangleOf([...letters, letter]))))} />
          )
        }
      </Zoom>
      <div class={lessonCss["ask"]}>
        <AddressField label="Address" text={text} onText={setText} />
        <p class={css["words"]} aria-live="polite">
          {address === null
            ? ""
            : point
              ? `A single point: the digits never end. Here you see as far as the first ${DEEP} of them.`
              : letters.length === 0
                ? "The whole shape. Press one of its pieces to go into it."
                : `A piece${size}. Press one of its pieces to go on.`}
        </p>
        <div class={css["whole"]}>
          <Seen address={address} />
        </div>
      </div>
    </div>
  );
}

type Spot = "corner" | "bottom" | "left" | "middle";
const SPOTS: Record<Spot, { name: string; at: Point }> = {
  corner: { name: "A", at: [1, 0] },
  bottom: { name: "B", at: [0.5, 0] },
  left: { name: "C", at: [0.25, HEIGHT / 2] },
  middle: { name: "D", at: [0.25, 0] },
};
const OPTIONS = [
  {
    value: "corner",
    label: "A, the corner of piece 2",
    wrong: "That is (2). Here the first digit is 1: the point is in piece 1, on the left. Type both above.",
  },
  { value: "bottom", label: "B, the middle of the bottom" },
  {
    value: "left",
    label: "C, the middle of the left side",
    wrong: "In piece 1 that is the top corner, so its digits go on with 3. Type 1(2) above and watch.",
  },
  {
    value: "middle",
    label: "D, the middle of the bottom of piece 1",
    wrong:
      "That is where 11 and 12 meet: its second digit may be 2, but then it goes on with 1. Type 1(2) above.",
  },
] as const;

function Which({ prediction }: { prediction: Prediction<Spot> }) {
  const { shown } = prediction;
  const address = useMemo(() => readOr("1(2)"), []);
  return (
    <ChoiceQuestion<Spot>
      prediction={prediction}
      ask={
        <>
          Which point is <Formula tex={tex`1(2)`} />, that is 1222…?
        </>
      }
      options={OPTIONS}
      truth="bottom"
      beside={
        <Drawn
          maps={MAPS}
          box={BOX}
          label="The gasket with four points: A its right corner, B the middle of its bottom, C that of its left side, D the middle of the bottom of piece 1."
        >
          {(place) => (
            <>
              {Object.values(SPOTS).map(({ name, at }) => {
                const [x, y] = place(at);
                return (
                  <g key={name}>
                    <circle class={css["here"]} cx={x} cy={y} r={4} />
                    <text class={css["spot"]} x={x} y={y + 18} text-anchor="middle">
                      {name}
                    </text>
                  </g>
                );
              })}
              {shown && address && <Mark place={place} at={pointOf(MAPS, address) ?? [0, 0]} kind="target" />}
            </>
          )}
        </Drawn>
      }
      line="B, and 2(1) is the same point."
    >
      <p>
        In piece 1, then always to the right: to the right corner of piece 1. In piece 2, then always to the
        left: to the left corner of piece 2. The two corners are one point, because there the pieces touch.
      </p>
      <p>
        So where pieces meet a point has an address in each. In a dust, whose pieces do not meet, every point
        has one address and no more: then the shape is nothing but a way to write rows of digits.
      </p>
    </ChoiceQuestion>
  );
}

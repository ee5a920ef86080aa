import { useMemo, useState } from "preact/hooks";
import type { Box } from "#document/framing";
import { Button } from "#ui/controls/Button";
import { useOwnId } from "#ui/id";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { gasket, HEIGHT } from "../../kit/maps/families";
import { apply, type Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { Drawn, type Place } from "../../kit/picture/annotated";
import { Choices, Reply } from "../frame/choices";
import { Exercise } from "../frame/exercise";
import { Lesson, Question, Truth } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, usePrediction } from "../frame/prediction";
import { type Address, pieceOf, pointOf, readAddress } from "./address";
import css from "./page.module.css";
import { TEACHING } from "./teaching";

const MAPS = gasket(0.5);
const BOX: Box = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
const TRIANGLE: readonly Point[] = [
  [0, 0],
  [1, 0],
  [0.5, HEIGHT],
];
const KEYS = ["1", "2", "3", "(", ")"] as const;

/** Addresses. */
export function Page(heading: Heading) {
  const prediction = usePrediction<Spot>(null);
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
            Type digits and watch where they lead. For a single point the digits have to go on for ever: 1(2)
            means 1222…, with the part in brackets again and again.
          </p>
        </>
      }
      question={<Which prediction={prediction} />}
      exercises={
        <>
          <Find
            number={1}
            target={[0.25, HEIGHT / 2]}
            hints={[
              "It is in piece 1 and in piece 3, where the two meet.",
              "In piece 1 it is the top corner: the digit 3, again and again.",
            ]}
          >
            Give an address of the marked point, the middle of the left side.
          </Find>
          <Find
            number={2}
            target={[1 / 3, 0]}
            hints={[
              "It is in piece 1. In there it is two thirds along: so in piece 2 of it. Within that it is one third along again.",
              "The same two digits come again and again.",
            ]}
          >
            Give an address of the marked point, one third along the bottom.
          </Find>
        </>
      }
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

interface SeenProps {
  text: string;
  onText: (text: string) => void;
  label: string;
}

/** An address to be typed, with buttons for fingers, and what is wrong with it. */
function AddressField({ text, onText, label }: SeenProps) {
  const id = useOwnId("address");
  const address = readAddress(text, MAPS.length);
  const problem = typeof address === "string" ? address : "";
  return (
    <div class={css["field"]}>
      <label for={id}>{label}</label>
      <input
        id={id}
        class={css["typed"]}
        type="text"
        inputMode="numeric"
        autocomplete="off"
        spellcheck={false}
        maxLength={30}
        value={text}
        aria-invalid={problem !== ""}
        aria-describedby={`${id}-problem`}
        onInput={(event) => onText(event.currentTarget.value)}
      />
      <div class={layout["buttons"]}>
        {KEYS.map((key) => (
          <Button key={key} onClick={() => onText(text + key)}>
            {key}
          </Button>
        ))}
        <Button onClick={() => onText(text.slice(0, -1))} disabled={text === ""}>
          Back
        </Button>
      </div>
      <p id={`${id}-problem`} class={layout["missing"]} aria-live="polite">
        {problem}
      </p>
    </div>
  );
}

/** The shape with the piece or the point of an address. */
function Seen({ address, target }: { address: Address | null; target?: Point }) {
  const piece = address ? pieceOf(MAPS, address) : null;
  const point = address ? pointOf(MAPS, address) : null;
  const steps = address?.first ?? [];
  const label =
    point !== null
      ? `The gasket with the point of that address, ${point[0].toFixed(3)} from the left and ${point[1].toFixed(3)} up.`
      : `The gasket with the piece of that address, ${2 ** steps.length} times smaller than the whole.`;
  return (
    <Drawn maps={MAPS} box={BOX} label={label}>
      {(place) => (
        <>
          {address &&
            steps.map((_, i) => {
              const inside = { first: steps.slice(0, i + 1), again: [] };
              return (
                <Outline key={i} place={place} map={pieceOf(MAPS, inside)} last={i === steps.length - 1} />
              );
            })}
          {target && <Mark place={place} at={target} kind="target" />}
          {piece && point && <Mark place={place} at={point} kind="here" />}
        </>
      )}
    </Drawn>
  );
}

function Outline({ place, map, last }: { place: Place; map: ReturnType<typeof pieceOf>; last: boolean }) {
  const corners = TRIANGLE.map((corner) => place(apply(map, corner)).join(" "));
  return <path class={`${css["piece"]} ${last ? css["last"] : ""}`} d={`M${corners.join("L")}Z`} />;
}

function Mark({ place, at, kind }: { place: Place; at: Point; kind: "here" | "target" }) {
  const [x, y] = place(at);
  return (
    <circle
      class={kind === "here" ? css["here"] : css["target"]}
      cx={x}
      cy={y}
      r={kind === "here" ? 5 : 10}
    />
  );
}

const readOr = (text: string) => {
  const address = readAddress(text, MAPS.length);
  return typeof address === "string" ? null : address;
};

function Typed() {
  const [text, setText] = useState("13");
  const address = readOr(text);
  const count = address?.first.length ?? 0;
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Seen address={address} />
      <div class={lessonCss["ask"]}>
        <AddressField label="Address" text={text} onText={setText} />
        <p aria-live="polite">
          {address === null
            ? ""
            : address.again.length > 0
              ? "A single point: the digits never end."
              : count === 0
                ? "The whole shape."
                : `A piece, ${2 ** count} times smaller than the whole.`}
        </p>
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
    <Question
      prediction={prediction}
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
      answer={
        <>
          <Reply options={OPTIONS} prediction={prediction} truth="bottom" />
          <Truth line="B, and 2(1) is the same point.">
            <p>
              In piece 1, then always to the right: to the right corner of piece 1. In piece 2, then always to
              the left: to the left corner of piece 2. The two corners are one point, because there the pieces
              touch.
            </p>
            <p>
              So where pieces meet a point has an address in each. In a dust, whose pieces do not meet, every
              point has one address and no more: then the shape is nothing but a way to write rows of digits.
            </p>
          </Truth>
        </>
      }
    >
      <Choices<Spot>
        ask={
          <>
            Which point is <Formula tex={tex`1(2)`} />, that is 1222…?
          </>
        }
        options={OPTIONS}
        prediction={prediction}
        truth="bottom"
      />
    </Question>
  );
}

interface FindProps {
  number: number;
  target: Point;
  hints: readonly string[];
  children: string;
}

function Find({ number, target, hints, children }: FindProps) {
  const [text, setText] = useState("");
  const address = readOr(text);
  const point = address && pointOf(MAPS, address);
  const off = point && Math.hypot(point[0] - target[0], point[1] - target[1]);
  const solved = off !== null && off < 1e-9;
  return (
    <Exercise
      number={number}
      ask={children}
      hints={hints}
      solved={solved}
      status={
        off === null
          ? "A point has digits without end: end with brackets."
          : solved
            ? `${text} leads there.`
            : `${text} leads to a point ${off.toFixed(3)} away from it.`
      }
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Seen address={address} target={target} />
        <AddressField label="Your address" text={text} onText={setText} />
      </div>
    </Exercise>
  );
}

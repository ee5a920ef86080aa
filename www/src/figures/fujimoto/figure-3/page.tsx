import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { Segmented } from "#ui/controls/Segmented";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { acrossAndUp, PointControls } from "../../kit/frame/point-controls";
import { studioHref } from "../../kit/frame/studio-link";
import type { Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { flag, oneOf, only, parts, point as pointOf, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { rightGasket } from "../codes/addresses";
import { codeOf, codeWords } from "../codes/codes";
import { squareMaps } from "../codes/square-maps";
import { deformationBy } from "../deformations/deformations";
import { LIFT, plainShade, thirds } from "../deformations/meshes";
import { Cell, type Chosen, COLUMNS, cellWords, Matrix } from "./shuffle-matrix";
import { meanParts, type Subject } from "./shuffled-image";
import { Letters, Source } from "./source";

const SQUARE = { dimensions: 2, parts: 2 } as const;
const SUBJECTS = [
  { value: "square", label: "(a) Square, L = 4" },
  { value: "gasket", label: "(b) Gasket, L = 3" },
] as const;

/** What stands in its address. */
export const STATE = {
  subject: kept<Subject>("square", oneOf(SUBJECTS.map(({ value }) => value))),
  shuffle: kept<Chosen>(
    { kb: 0, ke: 3, superposed: false },
    only(
      parts({ kb: whole(0, 2), ke: whole(0, COLUMNS), superposed: flag }),
      ({ kb, ke, superposed }) => kb <= ke && (!superposed || ke === COLUMNS),
    ),
  ),
  point: kept<Point>([0.7, 0.2], pointOf(0, 1)),
};

/** The colour matrix of shuffles. */
export function Page(heading: Heading) {
  const [subject, setSubject] = useKept("subject", ...STATE.subject);
  const [chosen, setChosen] = useKept("shuffle", ...STATE.shuffle);
  const [point, setPoint] = useKept("point", ...STATE.point);
  const at = useMemo(() => (subject === "square" ? point : inGasket(point)), [subject, point]);
  const code = codeOf(SQUARE, at, COLUMNS);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A picture whose colours run smoothly, red above left, blue below right, is cut up by the shuffle:
          each cell takes its colour from the cell whose code has the letters <Formula tex={tex`k_b + 1`} />{" "}
          to <Formula tex={tex`k_e`} /> in reverse order. To the right the detail grows; downwards the shuffle
          is kept within ever smaller cells (the white line). Choose an image, then press a place in it to see
          where its colour came from.
        </p>
      }
      found={<Found />}
      parameters={[
        { name: "Locality, by row", symbol: tex`k_b`, value: "0, 1, 2" },
        {
          name: "Detail, by column",
          symbol: tex`k_e`,
          value: [tex`k_b`, " to 5; superposed: all of them to 5"],
        },
        {
          name: "Roughness of the superposition",
          symbol: tex`\delta_c`,
          value: "1: all terms alike (eq 13)",
        },
        { name: "Chosen", value: cellWords(chosen) },
        { name: "The cell’s code", symbol: "α", value: codeWords(code) },
        { name: "Colours", value: "red (1 − x) y, blue x (1 − y), green the rest" },
      ]}
      captions={[
        "Figure 3: Examples of ext-unit-IST's on geometric shapes. (a) A unit cube. (b) A Sierpinski gasket.",
      ]}
      reconstructed="Rows, columns and the roughness of the superposition are the paper’s (section 5.2, eqs 10 to 12). The colour function is not printed: it is made from the text, which has the upper left redder, the lower right bluer, and the lower left or upper right greener than other parts. Where each row begins is reconstructed, too."
      studio={{
        href: studioHref({
          a: subject === "square" ? { name: "Square of four", maps: squareMaps(2) } : RIGHT,
          b: subject === "square" ? { name: "Square of four", maps: squareMaps(2) } : RIGHT,
          deform: deformationBy(LIFT, {
            kb: chosen.kb,
            ke: chosen.ke,
            superposed: chosen.superposed,
            phase: 0,
            tint: {
              colours: STUDIO_COLOURS,
              kb: chosen.kb,
              ke: chosen.ke,
              delta: 1,
              superposed: chosen.superposed,
            },
          }),
        }),
      }}
    >
      <div class={layout["controls"]}>
        <Segmented label="Shape" options={SUBJECTS} value={subject} onChange={setSubject} />
      </div>
      <Matrix subject={subject} chosen={chosen} onChoose={setChosen} />
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Panel name={cellWords(chosen)} caption="Press a place in it.">
          <Cell
            subject={subject}
            chosen={chosen}
            point={at}
            onPick={setPoint}
            label={`${cellWords(chosen)}, with the chosen cell ${codeWords(code)}.`}
          />
        </Panel>
        <Source subject={subject} chosen={chosen} point={at} />
      </div>
      <Letters chosen={chosen} point={at} />
      <div class={layout["controls"]}>
        <PointControls
          axes={acrossAndUp("The place")}
          step={1 / 32}
          point={at}
          said={(symbol, value) => `${symbol} = ${fixed(value, 3)}, cell ${codeWords(code)}`}
          onMove={setPoint}
        />
      </div>
    </Frame>
  );
}

const RIGHT = { name: "Right gasket", maps: rightGasket(0.5) };
/** The same colour function at 4 x 4 control points. */
const STUDIO_COLOURS = Array.from({ length: 16 }, (_, n) =>
  plainShade(thirds((n % 4) / 3, Math.floor(n / 4) / 3)),
);

/** The cell of the gasket at a point of the square: where both digits would be 1 the upper one is taken for 0. */
function inGasket([x, y]: Point): Point {
  const cells = 2 ** COLUMNS;
  const [i, j] = [x, y].map((at) => Math.min(cells - 1, Math.floor(at * cells))) as [number, number];
  const low = x >= y ? [i, j & ~i] : [i & ~j, j];
  return low.map((at) => (at + 0.4) / cells) as Point;
}

function Found() {
  const [plain, last, mean] = useMemo(
    () => [meanParts(0, 0, false), meanParts(0, 5, false), meanParts(0, 5, true)].map((of) => of),
    [],
  );
  if (!plain || !last || !mean) return null;
  const red = (of: typeof plain) => `${fixed(of.upperLeft[0])} against ${fixed(of.lowerRight[0])}`;
  return (
    <p>
      The paper says that the upper left stays redder than the lower right, however large{" "}
      <Formula tex={tex`k_e`} /> is. So it does, but hardly: the part of red in these two quarters of the
      square is {red(plain)} before any shuffle, and {red(last)} after the one of 0 to 5. The superposition
      remembers more, {red(mean)}, since its first terms leave things where they are. That is what makes a
      deformation both fractal and local.
    </p>
  );
}

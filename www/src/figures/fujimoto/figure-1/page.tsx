import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { acrossAndUp, PointControls } from "../../kit/frame/point-controls";
import { studioHref } from "../../kit/frame/studio-link";
import type { Point } from "../../kit/maps/pieces";
import { tex } from "../../kit/notation/tex";
import { point as pointOf, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { CodeRow } from "../codes/code-row";
import { type Cube, codeOf, codeWords, lettersOf } from "../codes/codes";
import { squareMaps } from "../codes/square-maps";
import { deformationBy } from "../deformations/deformations";
import { LIFT } from "../deformations/meshes";
import { CubeLine } from "./cube-line";
import { CubeSquare } from "./cube-square";
import css from "./page.module.css";

const PANELS: readonly { letter: string; cube: Cube }[] = [
  { letter: "a", cube: { dimensions: 1, parts: 2 } },
  { letter: "b", cube: { dimensions: 1, parts: 3 } },
  { letter: "c", cube: { dimensions: 2, parts: 2 } },
  { letter: "d", cube: { dimensions: 2, parts: 3 } },
];
const MOST_LETTERS = 6;

/** What stands in its address. */
export const STATE = {
  point: kept<Point>([0.62, 0.3], pointOf(0, 1)),
  letters: kept(2, whole(1, MOST_LETTERS)),
};

/** Address mappings on unit cubes. */
export function Page(heading: Heading) {
  const [point, setPoint] = useKept("point", ...STATE.point);
  const [letters, setLetters] = useKept("letters", ...STATE.letters);
  const [x, y] = point;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A code says where a point is, the coarse first: the first letter names a part of the whole, the next
          a part of that part, and so on without end. Look at one point in four such mappings at once, or
          press anywhere to choose another. A shuffle, in Figure 3, does nothing but put the letters in
          another order.
        </p>
      }
      found={
        <p>
          With {letters} {letters === 1 ? "letter" : "letters"} the point is known to within{" "}
          {PANELS.filter(({ cube }) => cube.dimensions === 2)
            .map(
              ({ cube }) =>
                `1/${cube.parts ** letters} of a side (${lettersOf(cube)} letters to choose from)`,
            )
            .join(" and ")}
          . A point on a border between cells has two codes, such as 1222… and 2111…; the program takes the
          second, so that every point has one (eq 7).
        </p>
      }
      parameters={[
        { name: "Letters to choose from", symbol: "L", value: "2 and 3 on the line, 4 and 9 on the square" },
        { name: "Letters shown", symbol: "k", value: String(letters) },
        { name: "The point", symbol: "s", value: [tex`(${fixed(x, 3)}, ${fixed(y, 3)})`] },
        ...PANELS.map(({ letter, cube }) => ({
          name: `Its code in (${letter})`,
          symbol: "α",
          value: `${codeWords(codeOf(cube, point, 8))} …`,
        })),
        { name: "First letter", value: "1 here, 0 in the paper" },
      ]}
      captions={["Figure 1: Address mappings on unit cubes."]}
      reconstructed="The paper’s drawing shows the first and second places of the codes (section 5.1, eq 7); which cell has which letter is reconstructed: from left to right, then upwards. Letters are counted from 1 on this page, as everywhere in Frond."
      studio={{
        href: studioHref({
          a: { name: "Square of four", maps: squareMaps(2) },
          b: { name: "Square of four", maps: squareMaps(2) },
          deform: deformationBy(LIFT, { ke: 6, phase: 1 }),
        }),
        label: "Bend the square in the studio",
      }}
    >
      <div class={layout["controls"]}>
        <SliderControl
          label="Letters"
          symbol="k"
          range={[1, MOST_LETTERS]}
          whole
          value={letters}
          valueText={`${letters} letters`}
          onChange={setLetters}
        />
        <PointControls axes={acrossAndUp("The point")} point={point} onMove={setPoint} />
      </div>
      <div class={css["cubes"]}>
        {PANELS.map(({ letter, cube }) => {
          const code = codeOf(cube, point, 8);
          const label = `(${letter}) ${cube.dimensions === 1 ? "A line" : "A square"} in ${lettersOf(cube)} parts, each again and again: the point has the code ${codeWords(code.slice(0, letters))}.`;
          const part = { cube, letters, point, label };
          return (
            <Panel
              key={letter}
              name={`(${letter})`}
              words={`L = ${lettersOf(cube)}`}
              caption={<CodeRow code={code} strong={letters} more />}
            >
              {cube.dimensions === 1 ? (
                <CubeLine {...part} onPick={(at) => setPoint([at, y])} />
              ) : (
                <CubeSquare {...part} onPick={setPoint} />
              )}
            </Panel>
          );
        })}
      </div>
    </Frame>
  );
}

import { useMemo } from "preact/hooks";
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
import { addresses, onGasket, pieceOf, rightGasket } from "../codes/addresses";
import { codeWords } from "../codes/codes";
import { deformationBy } from "../deformations/deformations";
import { LIFT } from "../deformations/meshes";
import { Steps } from "./address-steps";
import css from "./page.module.css";

const GASKETS = [
  { letter: "a", r: 0.5, words: "pieces of ½, which touch" },
  { letter: "b", r: 0.55, words: "pieces of 0.55, which overlap" },
] as const;
const MOST_STEPS = 7;
/** Letters of the addresses that are told, and how many of them. */
const LETTERS = 6;
const TOLD = 4;

/** What stands in its address. */
export const STATE = {
  point: kept<Point>([0.5, 0], pointOf(0, 1)),
  steps: kept(2, whole(2, MOST_STEPS)),
};

/** Address mappings on attractors. */
export function Page(heading: Heading) {
  const [point, setPoint] = useKept("point", ...STATE.point);
  const [steps, setSteps] = useKept("steps", ...STATE.steps);
  const found = useMemo(
    () =>
      GASKETS.map(({ r }) => {
        const at = onGasket(r, point);
        return { at, words: addresses(r, at, LETTERS) };
      }),
    [point],
  );
  const [touching, overlapping] = found.map(({ words }) => words.length);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          On an attractor the letters are its maps: the first letter of a code says in which copy of the whole
          a point is, the next in which copy within that. Look at the ring. In (a) it is where two copies
          touch, in (b) where they lie over each other: there several codes lead to one place. Press anywhere
          to move it.
        </p>
      }
      found={
        <p>
          With {LETTERS} letters the ring has {countWords(touching ?? 0)} in (a) and{" "}
          {countWords(overlapping ?? 0)} in (b). For the paper, and for Frond, each of them is a point of its
          own that happens to have the same coordinates (section 5.1), so a deformation may take them apart:
          where pieces overlap, each goes its own way, and where they touch in (a) something has to keep the
          two together. Figure 4 tells what.
        </p>
      }
      parameters={[
        {
          name: "Maps of (a)",
          value: [
            tex`f_i(x) = \frac{1}{2} x + c_i`,
            tex`c_1 = (0, 0)`,
            tex`c_2 = (\frac{1}{2}, 0)`,
            tex`c_3 = (0, \frac{1}{2})`,
          ],
        },
        {
          name: "Maps of (b)",
          value: [
            tex`f_i(x) = 0.55\, x + c_i`,
            tex`c_1 = (0, 0)`,
            tex`c_2 = (0.45, 0)`,
            tex`c_3 = (0, 0.45)`,
          ],
        },
        { name: "Letters to choose from", symbol: "L", value: "3" },
        { name: "Steps shown in the middle", value: String(steps) },
        ...GASKETS.map(({ letter }, i) => ({
          name: `The ring in (${letter})`,
          value: `(${(found[i]?.at ?? [0, 0]).map((x) => fixed(x, 3)).join(", ")})`,
        })),
        { name: "First letter", value: "1 here, 0 in the paper" },
      ]}
      captions={["Figure 2: Address mappings on IFS attractors."]}
      reconstructed="The maps are the paper’s own (section 5.1). Its drawing shows two steps and the attractor; more steps and the ring are added here."
      studio={{
        href: studioHref({
          a: { name: "Right gasket", maps: rightGasket(0.5) },
          b: { name: "Gasket of 0.55", maps: rightGasket(0.55) },
          deform: deformationBy(LIFT, { phase: 1 }),
        }),
        label: "Bend the gasket in the studio",
      }}
    >
      <div class={layout["controls"]}>
        <SliderControl
          label="Steps in the middle"
          range={[2, MOST_STEPS]}
          whole
          value={steps}
          valueText={`${steps} steps`}
          onChange={setSteps}
        />
        <PointControls axes={acrossAndUp("The ring")} point={point} onMove={setPoint} />
      </div>
      {GASKETS.map(({ letter, r, words }, i) => {
        const { at, words: codes } = found[i] ?? { at: [0, 0] as Point, words: [] };
        const here = (depth: number) => [...new Set(codes.map((code) => codeWords(code.slice(0, depth))))];
        return (
          <div key={letter} class={layout["film-row"]}>
            <h2>
              ({letter}) {words}
            </h2>
            <div class={`${layout["triple"]} ${layout["stages"]}`}>
              {[1, steps, null].map((depth, column) => (
                <Panel
                  key={column === 2 ? "whole" : column}
                  caption={
                    <>
                      {depth === null ? "the attractor" : depth === 1 ? "step 1" : `step ${depth}`}
                      {depth !== null && (
                        <span class="number"> in {here(depth).slice(0, TOLD).join(", ")}</span>
                      )}
                    </>
                  }
                >
                  <Steps
                    r={r}
                    depth={depth}
                    point={at}
                    onPick={setPoint}
                    here={codes.map((code) => pieceOf(rightGasket(r), code.slice(0, depth ?? 0)))}
                    label={`(${letter}) ${depth === null ? "The attractor" : `Step ${depth}`}, with the ring at (${at.map((x) => fixed(x)).join(", ")})${depth === null ? "" : ` in ${here(depth).join(" and ")}`}.`}
                  />
                </Panel>
              ))}
            </div>
            <p class={`${css["address-list"]} number`}>
              {codes.slice(0, TOLD).map((code) => (
                <span key={codeWords(code)} class={css["address"]}>
                  {codeWords(code)}…
                </span>
              ))}
              {codes.length > TOLD && <span>and {codes.length - TOLD} more</span>}
            </p>
          </div>
        );
      })}
    </Frame>
  );
}

function countWords(count: number): string {
  return count === 1 ? "one address" : `${count} addresses`;
}

import { useMemo } from "preact/hooks";
import { fixed, formatNumber } from "#format/numbers";
import { TABLE_3 as TABLE_3_GRAPH } from "#tools/fit/graph/printed";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { fitHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { number, oneOf, parts } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { bestCopy, type Heights, heightsAlong, TOP } from "../graphs/arrowhead";
import { rangeOf } from "../graphs/graphs";
import { Profile } from "../graphs/profile";
import css from "./page.module.css";

const T = {
  min: 0,
  max: 1,
  ticks: [0, 1 / 3, 2 / 3, 1],
  format: (t: number) => ["0", "⅓", "⅔", "1"][Math.round(3 * t)] ?? "",
  name: "t",
};
const DEPTH = 7;
const THIRDS = [
  { value: "0", label: "Left" },
  { value: "1", label: "Middle" },
  { value: "2", label: "Right" },
  { value: "none", label: "None" },
] as const;
type Third = (typeof THIRDS)[number]["value"];
/** Nearer than this, in parts of the height, is a copy to the last pixel. */
const SAME = 1e-9;

/** What stands in its address. */
export const STATE = {
  heights: kept<Heights>(TOP, parts({ A: number(0, 1, 2), B: number(0, 1, 2), C: number(0, 1, 2) })),
  third: kept<Third>("0", oneOf(THIRDS.map(({ value }) => value))),
};

/** The top projection of the space curve, a function that is no copy of itself. */
export function Page(heading: Heading) {
  const [heights, setHeights] = useKept("heights", ...STATE.heights);
  const [third, setThird] = useKept("third", ...STATE.third);
  const whole = useMemo(() => heightsAlong(DEPTH, heights), [heights]);
  const copies = useMemo(() => [0, 1, 2].map((i) => bestCopy(whole, i)), [whole]);
  const copy = third === "none" ? undefined : copies[Number(third)];
  const y = { ...rangeOf([whole], { min: 0, max: 1 }), name: "x" };
  const setHeight = (corner: keyof Heights) => (value: number) => setHeights({ ...heights, [corner]: value });
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Look at the space curve of Figure 3 from above, and this is its x over t. Is it made of copies of
          itself? Lay the whole, squeezed as well as one map can, over each of its thirds. In the middle it
          fits exactly. At the sides it never does, forwards or backwards, whatever the roughness: the graph
          is rough, and yet it is no fractal interpolation function.
        </p>
      }
      found={
        <p>
          The best copy of the whole misses the left third by {percent(copies[0]?.rms)} of the height, the
          middle by {percent(copies[1]?.rms)}, the right by {percent(copies[2]?.rms)}. That is a fact about
          copies of the <em>whole</em>. Parts of this graph do repeat elsewhere in it, and Figure 6 builds all
          of it from such parts alone, without the hidden height.
        </p>
      }
      parameters={[
        ...(["A", "B", "C"] as const).map((corner) => ({
          name: `Height of corner ${corner}`,
          value: formatNumber(heights[corner]),
        })),
        { name: "Pieces drawn", symbol: tex`3^${DEPTH}`, value: String(3 ** DEPTH) },
        ...(copy
          ? [
              { name: "Roughness of the best copy", symbol: "c", value: fixed(copy.c, 3) },
              { name: "It runs", value: copy.reflected ? "backwards" : "forwards" },
            ]
          : []),
      ]}
      captions={['Figure 4: The "top" projection of the Sierpinski space curve.']}
      reconstructed="Corner heights of 0, ½ and 1 are reconstructed: with them the printed maps of Table 3 come about as near as the paper says (Figure 6). Other heights are other projections of the same curve, seen from other sides."
      studio={{ href: fitHref({ mode: "graph", graph: TABLE_3_GRAPH }), label: "Open in the Fit tool" }}
    >
      <div class={layout["controls"]}>
        <Choice label="Lay the whole over a third" options={THIRDS} value={third} onChange={setThird} />
      </div>
      <Profile
        label={`The height of the curve over t${copy ? `, and over its ${thirdName(third)} third the whole, squeezed: ${missWords(copy.rms)}` : ""}`}
        x={T}
        y={y}
        height={340}
        rules={[1 / 3, 2 / 3]}
        lines={[
          { points: whole, colour: "ink", width: 1.25 },
          ...(copy ? [{ points: copy.points, colour: 5, width: 2 }] : []),
        ]}
      />
      <p class={css["copy-words"]} role="status">
        {copy
          ? `${thirdName(third, true)} third: the best copy of the whole ${copy.reflected ? "runs backwards" : "runs forwards"} with c = ${fixed(copy.c, 3)}; ${missWords(copy.rms)}.`
          : "The graph alone."}
      </p>
      <div class={layout["controls"]}>
        {(["A", "B", "C"] as const).map((corner) => (
          <SliderControl
            key={corner}
            label={`height of corner ${corner}`}
            value={heights[corner]}
            onChange={setHeight(corner)}
          />
        ))}
      </div>
    </Frame>
  );
}

function thirdName(third: Third, first = false): string {
  const name = THIRDS.find((one) => one.value === third)?.label ?? "";
  return first ? name : name.toLowerCase();
}

function missWords(rms: number): string {
  return rms < SAME ? "it is the same" : `it misses by ${percent(rms)} of the height`;
}

function percent(part: number | undefined): string {
  if (part === undefined) return "–";
  return part < SAME ? "nothing" : `${fixed(100 * part, 1)}%`;
}

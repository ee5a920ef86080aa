import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { TABLE_3 as TABLE_3_GRAPH } from "#tools/fit/graph/printed";
import type { Graph } from "#wasm/api";
import { loadCurves, rough } from "#wasm/curve";
import { Choice, SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { fitHref } from "../../kit/frame/studio-link";
import { Table } from "../../kit/frame/table";
import { oneOf, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { heightsAlong, TOP } from "../graphs/arrowhead";
import { byPiece, rangeOfPiece } from "../graphs/graphs";
import { MapTable } from "../graphs/map-table";
import { FIGURE_6, TABLE_3, TABLE_3_EXACT } from "../graphs/printed-tables";
import { type Line, Profile } from "../graphs/profile";
import { breakpoints, fractionWords, type Misses, missesOf } from "../graphs/table-3";
import css from "./page.module.css";

const T = { min: 0, max: 1, ticks: [0, 1 / 3, 2 / 3, 1], format: fractionWords, name: "t" };
const HEIGHTS = { min: -0.02, max: 1.02, ticks: [0, 0.25, 0.5, 0.75, 1], name: "x" };
const MOST_PIECES = 64;
const MISSED = { min: 0, max: 0.1, ticks: [0, 0.05, 0.1], name: "distance" };

type Model = "pfif" | "printed" | "rfif";

/** Table 3 to its three digits. */
const PRINTED: Graph = { kind: "pfif", pieces: [...TABLE_3] };

/** What stands in its address. */
export const STATE = {
  model: kept<Model>("pfif", oneOf(["pfif", "printed", "rfif"])),
  piece: kept(0, whole(0, MOST_PIECES - 1)),
};

/** What must be there before it is shown. */
export const needs = [loadCurves];

/** The seven maps of Table 3, how far they are off, and the same function as an RFIF. */
export function Page(heading: Heading) {
  const [model, setModel] = useKept("model", ...STATE.model);
  const [chosen, setChosen] = useKept("piece", ...STATE.piece);
  const original = useMemo(() => heightsAlong(6, TOP), []);
  const recurrent = useMemo(() => rough.toRecurrent(TABLE_3_GRAPH, MOST_PIECES), []);
  const graph: Graph =
    model === "rfif" && recurrent ? recurrent : model === "printed" ? PRINTED : TABLE_3_GRAPH;
  const order = useMemo(() => leftToRight(graph), [graph]);
  const index = Math.min(chosen, order.length - 1);
  const samples = useMemo(() => rough.sampleGraph(graph, { tolerance: 0.004, most: 20_000 }), [graph]);
  const exact = useMemo(() => missesOf(TABLE_3_EXACT), []);
  const printed = useMemo(() => missesOf(TABLE_3), []);
  const knots = breakpoints(graph);
  const piece = order[index];
  const lines: Line[] = [
    { points: original, colour: "quiet", width: 1 },
    ...byPiece({ ...graph, pieces: order }, samples).map((points, i) => ({
      points,
      colour: i === index ? 5 : 1,
      width: i === index ? 3 : 1.25,
    })),
    ...(piece ? [{ points: within(samples, ...piece.domain), colour: 0, width: 1.75, dashed: true }] : []),
  ];
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The function of Figure 4 is no copy of itself, and still seven maps make it, nearly: each copies a{" "}
          <em>part</em> of the graph. Step through the pieces: the thick one is a copy of the dashed one. The
          paper’s authors found the maps by voting and refined them by hand. They could not say whether the
          same could be done with parts that begin and end where pieces do. It can: switch to eleven pieces.
        </p>
      }
      found={
        <p>
          {recurrent === null
            ? ""
            : `As an RFIF the function has ${recurrent.pieces.length} pieces with breakpoints at ${breakpoints(recurrent).map(fractionWords).join(", ")}: every end of a domain is one of them. It is the same graph, point by point. `}
          The seven maps miss the original by {fixed(exact.worst, 4)} at most, near t = {fixed(exact.at, 3)},
          where no map of Table 3 is quite right; in the middle third, a copy of all, the misses repeat at
          half the size.
        </p>
      }
      parameters={[
        { name: "Pieces", value: `${graph.pieces.length}, ${model === "rfif" ? "an RFIF" : "a PFIF"}` },
        { name: "Breakpoints", symbol: "t", value: knots.map(fractionWords).join(", ") },
        ...(piece
          ? [
              {
                name: `Piece ${index + 1} covers`,
                value: intervalWords(Object.values(rangeOfPiece(piece)) as [number, number]),
              },
              { name: "and copies", value: intervalWords(piece.domain) },
            ]
          : []),
        { name: "Measured at", value: "2188 points, 2187 even steps" },
      ]}
      captions={[
        "Figure 6: Error of the approximation of the hidden-variable fractal function by a partitioned fractal interpolation function. Maximum error is 0.0858 and mean squared error is 0.000180.",
        "Table 3: PFIF parameters used to approximate the curve in Figure 4.",
      ]}
      reconstructed="The maps are printed, but with three digits their pieces leave slits, and two overlap. The picture uses the fractions that the table rounds, or, “as printed”, the table itself: in a slit the nearer end goes on. What the function is compared with is Figure 4, rebuilt."
      differs="At which points the paper measured is not said, and the maximum hangs on it. From which clusters the seven maps came is said (1, 7, 8, 13, 14, 25 and 30 of the top 100); with other bins the ranks are others."
      studio={{ href: fitHref({ mode: "graph", graph }), label: "Open in the Fit tool" }}
    >
      <div class={layout["controls"]}>
        <Choice
          label="Pieces"
          options={[
            { value: "pfif", label: "7, a PFIF", description: "Pieces copy any parts" },
            {
              value: "printed",
              label: "7, as printed",
              description: "Three digits, with slits between pieces",
            },
            {
              value: "rfif",
              label: `${recurrent?.pieces.length ?? 11}, an RFIF`,
              description: "Pieces copy what lies between breakpoints",
              disabled: recurrent === null,
            },
          ]}
          value={model}
          onChange={setModel}
        />
        <SliderControl
          label="piece"
          range={[1, order.length]}
          whole
          value={index + 1}
          text={`${index + 1} of ${order.length}`}
          valueText={
            piece ? `piece ${index + 1} of ${order.length}, a copy of ${intervalWords(piece.domain)}` : ""
          }
          onChange={(next) => setChosen(next - 1)}
        />
      </div>
      <Profile
        label={`The function of ${graph.pieces.length} maps over the original, with breakpoints at ${knots.map(fractionWords).join(", ")}`}
        x={model === "rfif" ? { ...T, ticks: [], name: "" } : T}
        y={HEIGHTS}
        height={340}
        rules={knots}
        lines={lines}
      >
        {(place, size) =>
          model === "rfif" ? (
            <svg class={css["knot-names"]} width={size.width} height={size.height} aria-hidden="true">
              {knots.map((t, i) => (
                <text
                  key={t}
                  x={place(t, 0)[0]}
                  y={size.height + (i % 2 === 0 ? 14 : 26)}
                  text-anchor="middle"
                >
                  {fractionWords(t)}
                </text>
              ))}
            </svg>
          ) : null
        }
      </Profile>
      <Profile
        label={`The distance of the seven maps from the original over t: ${fixed((model === "printed" ? printed : exact).worst, 4)} at most`}
        x={T}
        y={MISSED}
        height={150}
        lines={[{ points: (model === "printed" ? printed : exact).all, colour: 3, width: 1.25 }]}
      />
      <div class={layout["two-columns"]}>
        <MapTable
          caption={model === "rfif" ? "The same function as an RFIF" : "Table 3"}
          first="Piece"
          digits={model === "rfif" ? 4 : 3}
          before={["domain"]}
          rows={
            model === "rfif"
              ? order.map(({ map, domain }, i) => ({
                  name: i + 1,
                  map,
                  before: [intervalWords(domain)],
                }))
              : TABLE_3.map(({ map, domain }, i) => ({
                  name: i + 1,
                  map,
                  before: [`[${fixed(domain[0], 3)}, ${fixed(domain[1], 3)}]`],
                }))
          }
        />
        <Errors exact={exact} printed={printed} />
      </div>
    </Frame>
  );
}

function Errors({ exact, printed }: { exact: Misses; printed: Misses }) {
  const rows = [
    { name: "in the paper", worst: FIGURE_6.worst, meanSquare: FIGURE_6.meanSquare },
    { name: "here, three digits", ...printed },
    { name: "here, fractions", ...exact },
  ];
  return (
    <Table caption="Distance from the original" columns={["Table 3", "maximum", "mean square"]}>
      <tbody>
        {rows.map(({ name, worst, meanSquare }) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            <td>{fixed(worst, 4)}</td>
            <td>{fixed(meanSquare, 6)}</td>
          </tr>
        ))}
      </tbody>
    </Table>
  );
}

function leftToRight(graph: Graph): Graph["pieces"] {
  return [...graph.pieces].sort((p, q) => rangeOfPiece(p).from - rangeOfPiece(q).from);
}

function intervalWords([from, to]: readonly [number, number]): string {
  return `[${fractionWords(from)}, ${fractionWords(to)}]`;
}

/** The samples of an interval. */
function within(samples: Float64Array, from: number, to: number): number[] {
  const kept: number[] = [];
  for (let i = 0; i + 1 < samples.length; i += 2) {
    const t = samples[i] ?? 0;
    if (t >= from - 1e-9 && t <= to + 1e-9) kept.push(t, samples[i + 1] ?? 0);
  }
  return kept;
}

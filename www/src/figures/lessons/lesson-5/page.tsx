import { useEffect, useMemo, useState } from "preact/hooks";
import { fixed } from "#format/numbers";
import { epoch, submit } from "#workers/pool/engine";
import { median } from "../../kit/connectedness/bisection";
import { exactJob, measureJob, PAPER, SIZES, searches } from "../../kit/connectedness/critical-scale";
import { Buffer } from "../../kit/connectedness/index-buffer";
import { Formula } from "../../kit/frame/formula";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { Table } from "../../kit/frame/table";
import tableCss from "../../kit/frame/table.module.css";
import { gasket } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { number } from "../../kit/state/fields";
import { useChannel, useValue } from "../../kit/workers";
import { Guess } from "../frame/choices";
import { Lesson, Question, Truth } from "../frame/lesson";
import { nearWords, type Prediction, usePrediction } from "../frame/prediction";
import { NotBetter, OtherWay } from "./exercises";
import { bufferOf, Pixels } from "./seen";
import { TEACHING } from "./teaching";

const SHOWN = 0.49;
const PIXELS = [25, 75, 225] as const;
const ASKED = 75;
/** Enough that every pixel of 75 by 75 that holds anything is hit many times. */
const POINTS = 200_000;
const SEED = 1;
const [LOWEST, HIGHEST] = [0.46, 0.505];
/** So near to it is right. */
const CLOSE = 0.0015;

/** The resolution's lie. */
export function Page(heading: Heading) {
  const prediction = usePrediction<number>(LOWEST, number(LOWEST, HIGHEST));
  const r = prediction.guess ?? LOWEST;
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            A computer often judges by the picture: if two pieces have a pixel in common, it says, they touch.
            Below is three times the same shape, with true gaps of a fiftieth of its side. Squares with a hole
            mark the pixels that two pieces share.
          </p>
          <p>
            With 25 pixels a side all three pieces seem to hang together. With 75 they are seen to be apart.
            The shape has not changed; only the pixels have. A picture tells the truth about itself, and no
            more.
          </p>
        </>
      }
      question={<Seeing prediction={prediction} r={r} />}
      exercises={
        <>
          <OtherWay />
          <NotBetter />
        </>
      }
      teaching={TEACHING}
      parameters={[
        {
          name: "Maps, towards the corners of a triangle of side 1",
          value: [tex`f_i(x) = r x + (1 - r)\, c_i`],
        },
        { name: "Scale in the pictures above", symbol: "r", value: String(SHOWN) },
        { name: "Points in each picture", value: "40 000 of the chaos game" },
        { name: "Points in each buffer that is measured", value: "200 000" },
        { name: "Pair subdivision", symbol: "ε", value: [tex`10^{-6}`, " of the size"] },
      ]}
      sources={
        <p>
          The numbers of the column “paper” are Table 1 of Burch and Hart (1997); the page{" "}
          <a href="#figures/table-1">Table 1</a> measures all four resolutions. Pair subdivision is Frond’s
          own.
        </p>
      }
      studio={{
        href: studioHref({
          a: { name: "Gasket, maps at 0.46", maps: gasket(LOWEST) },
          b: { ...preset("gasket") },
          t: Math.min(1, (r - LOWEST) / (0.5 - LOWEST)),
        }),
      }}
    >
      <div class={layout["triple"]}>
        {PIXELS.map((size) => (
          <Pixels key={size} r={SHOWN} size={size} />
        ))}
      </div>
    </Lesson>
  );
}

function Seeing({ prediction, r }: { prediction: Prediction<number>; r: number }) {
  const { shown } = prediction;
  const run = useMemo(() => bufferOf(r, ASKED), [r]);
  const measured = useMeasured(shown);
  const seen = measured.found.length > 0 ? median(measured.found) : null;
  return (
    <Question
      prediction={prediction}
      truth={seen}
      within={CLOSE}
      beside={
        <Buffer
          run={run}
          count={run.count}
          marked={shown}
          label={`The triangle with pieces of scale ${fixed(r, 3)} in 75 by 75 pixels.`}
        />
      }
      answer={
        <Truth
          line={
            seen === null
              ? "Measuring …"
              : `You said ${fixed(r, 4)}. Here 75 pixels say connected from ${fixed(seen, 4)} on. ${nearWords(r, seen, { close: CLOSE, fair: 0.006 })}`
          }
        >
          <Lies found={measured.found} exact={measured.exact} />
          <p>
            A pixel is about a seventieth of the side. A gap much narrower than that mostly falls inside one,
            and then it is gone. Twice the pixels halve the lie but never end it. Pair subdivision has no
            pixels: it bounds pieces, and pieces of pieces, until they are proved apart.
          </p>
        </Truth>
      }
    >
      <Guess
        ask="In truth the pieces part below ½. From which scale on do 75 pixels call them connected?"
        label="Scale of the pieces"
        symbol="r"
        min={LOWEST}
        max={HIGHEST}
        step={0.0005}
        format={(value) => fixed(value, 4)}
        prediction={prediction}
        truth={seen}
      />
    </Question>
  );
}

function Lies({ found, exact }: { found: readonly number[]; exact: number | null }) {
  const here = found.length > 0 ? fixed(median(found), 4) : "…";
  return (
    <Table
      caption={
        <>
          Least scale <Formula>r</Formula> that is called connected
        </>
      }
      columns={["Judged by", "Paper", "Here"]}
    >
      <tbody>
        {SIZES.map((size, i) => (
          <tr key={size}>
            <th scope="row">{size} pixels a side</th>
            <td>{fixed(PAPER[i] ?? Number.NaN, 5)}</td>
            <td class={tableCss["strong"]}>{size === ASKED ? here : ""}</td>
          </tr>
        ))}
        <tr>
          <th scope="row">pair subdivision</th>
          <td>–</td>
          <td class={tableCss["strong"]}>{exact === null ? "…" : fixed(exact, 7)}</td>
        </tr>
        <tr>
          <th scope="row">in theory</th>
          <td>0.50000</td>
          <td>0.5</td>
        </tr>
      </tbody>
    </Table>
  );
}

/** The scale at which 75 pixels turn, for nine windows; and where pair subdivision does. Asked for once. */
function useMeasured(wanted: boolean): { found: number[]; exact: number | null } {
  const [channel, exactChannel] = [useChannel(), useChannel()];
  const [found, setFound] = useState<number[]>([]);
  const [exact, setExact] = useState<number | null>(null);
  const host = useValue(epoch);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another host has to be asked anew
  useEffect(() => {
    if (!wanted) return;
    const all = searches().filter(({ size, window }) => size === ASKED && window !== null);
    const done = () =>
      setFound(all.filter(({ bisection }) => bisection.done).map(({ bisection }) => bisection.high));
    submit(exactJob(exactChannel, 1e-6, setExact));
    submit(measureJob(channel, all, { points: POINTS, seed: SEED }, { progress() {}, done, fail() {} }));
  }, [wanted, channel, exactChannel, host]);
  return { found, exact };
}

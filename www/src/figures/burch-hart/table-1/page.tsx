import { useEffect, useState } from "preact/hooks";
import { fixed, formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { cancel, epoch, submit } from "#workers/pool/engine";
import { Plot } from "../../kit/chart/plot";
import { median } from "../../kit/connectedness/bisection";
import {
  exactJob,
  MARGIN,
  measureJob,
  PAPER,
  RUNS,
  type Search,
  SIZES,
  searches,
  WINDOWS,
} from "../../kit/connectedness/critical-scale";
import { Choice } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { Table } from "../../kit/frame/table";
import tableCss from "../../kit/frame/table.module.css";
import { gasket } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { oneOf } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { useChannel, useValue } from "../../kit/workers";

const SEED = 1;
const EPSILON = 1e-6;
const POINTS = [
  { value: "100000", label: "100 000" },
  { value: "300000", label: "300 000" },
  { value: "1000000", label: "1 000 000" },
] as const;
type Points = (typeof POINTS)[number]["value"];

/** What stands in its address. */
export const STATE = {
  points: kept<Points>("1000000", oneOf(POINTS.map(({ value }) => value))),
};

/** The accuracy of the index buffer, measured. */
export function Page(heading: Heading) {
  const [points, setPoints] = useKept("points", ...STATE.points);
  const measured = useMeasurement(Number(points));
  const rows = rowsOf(measured.all);
  const grouped = POINTS.find((one) => one.value === points)?.label ?? points;
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Shrink the three maps of the gasket below one half and it falls apart, but pixels do not see the
          gaps at once. The table says from which scale on the index buffer calls it connected: the nearer to
          ½, the better it sees. Where the window lies decides a good part of that, so {WINDOWS} windows are
          tried, each shifted by a part of a pixel.
        </p>
      }
      found={<Found rows={rows} done={measured.state === "done"} />}
      parameters={[
        {
          name: "Maps",
          value: [tex`f_i(x) = r x + (1 - r)\, c_i`, ", the ", tex`c_i`, " being the corners of a triangle"],
        },
        { name: "Points of the chaos game", symbol: "n", value: grouped },
        { name: "Chances of the maps", value: "⅓ each" },
        { name: "Seeds", value: `${SEED} to ${SEED + WINDOWS - 1}, one a window` },
        { name: "Window", value: `square, ${100 * MARGIN}% larger than the gasket` },
        { name: "Search", value: "bisection between 0.45 and 0.53, to 0.0001" },
        { name: "Pair subdivision", symbol: "ε", value: [tex`10^{-6}`, " of the size"] },
      ]}
      captions={["Table 1: Accuracy of image connectedness."]}
      reconstructed="The paper states neither the number of points nor where its window lies, so its column cannot be repeated, only compared."
      studio={{
        href: studioHref({
          a: { name: "Gasket, maps at 0.45", maps: gasket(0.45) },
          b: preset("gasket"),
          t: 0.9,
        }),
      }}
    >
      <div class={layout["controls"]}>
        <Choice
          label="Points"
          name="Points of each buffer"
          options={POINTS}
          value={points}
          onChange={setPoints}
        />
        <div class={layout["buttons"]}>
          {measured.state === "running" ? (
            <Button onClick={measured.stop}>Stop</Button>
          ) : (
            <Button icon="reset" onClick={measured.again}>
              Measure again
            </Button>
          )}
        </div>
      </div>
      <Progress measured={measured} />
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Measurements rows={rows} exact={measured.exact} />
        <Errors rows={rows} />
      </div>
    </Frame>
  );
}

interface Row {
  size: number;
  paper: number;
  /** The shifted windows that are done. */
  found: number[];
  /** The window in the middle, once it is done. */
  centred: number | null;
}

function rowsOf(all: readonly Search[]): Row[] {
  return SIZES.map((size, i) => {
    const mine = all.filter((search) => search.size === size && search.bisection.done);
    const centred = mine.find((search) => search.window === null);
    return {
      size,
      paper: PAPER[i] ?? Number.NaN,
      found: mine.filter((search) => search.window !== null).map((search) => search.bisection.high),
      centred: centred?.bisection.high ?? null,
    };
  });
}

function Measurements({ rows, exact }: { rows: readonly Row[]; exact: number | null }) {
  const part = (row: Row, text: (found: number[]) => string) =>
    row.found.length > 0 ? text(row.found) : "…";
  return (
    <Table
      caption={
        <>
          Least scale <Formula>r</Formula> that is called connected
        </>
      }
      columns={["Resolution", "Paper", `Here, middle of ${WINDOWS}`, "from … to"]}
    >
      <tbody>
        {rows.map((row) => (
          <tr key={row.size}>
            <th scope="row">
              {row.size} × {row.size}
            </th>
            <td>{fixed(row.paper, 5)}</td>
            <td class={tableCss["strong"]}>{part(row, (found) => fixed(median(found), 4))}</td>
            <td>
              {part(row, (found) => `${fixed(Math.min(...found), 4)} – ${fixed(Math.max(...found), 4)}`)}
            </td>
          </tr>
        ))}
      </tbody>
      <tbody>
        <tr>
          <th scope="row">pair subdivision</th>
          <td>–</td>
          <td class={tableCss["strong"]}>{exact === null ? "…" : fixed(exact, 7)}</td>
          <td>no pixels</td>
        </tr>
        <tr>
          <th scope="row">in theory</th>
          <td>0.50000</td>
          <td>0.5</td>
          <td />
        </tr>
      </tbody>
    </Table>
  );
}

function Errors({ rows }: { rows: readonly Row[] }) {
  const off = (r: number) => (r < 0.5 ? 0.5 - r : Number.NaN);
  const here = rows
    .filter((row) => row.found.length > 0)
    .map((row) => [row.size, off(median(row.found))] as const);
  return (
    <Plot
      label="How far below one half the buffer first says connected, by resolution, for the paper and for the measurement here. Both fall as the resolution rises."
      x={{ name: "pixels a side", min: 60, max: 750, log: true, ticks: SIZES }}
      y={{
        name: "½ − r",
        min: 1e-4,
        max: 0.05,
        log: true,
        ticks: [1e-4, 1e-3, 1e-2],
        format: (value) => formatNumber(value, 4),
      }}
      series={[
        {
          name: "paper",
          points: rows.map((row) => [row.size, off(row.paper)] as const),
          colour: 5,
          dashed: true,
          dots: true,
          nameAt: 1,
        },
        {
          name: "here",
          points: here,
          colour: 1,
          dots: true,
          nameAt: Math.min(1, here.length - 1),
          raise: -18,
        },
      ]}
    />
  );
}

function Progress({ measured }: { measured: Measurement }) {
  const { state, answered, seconds, problem } = measured;
  const text = {
    running: `${answered} of ${RUNS} buffers`,
    stopped: `stopped after ${answered} of ${RUNS} buffers`,
    done: `${RUNS} buffers in ${fixed(seconds, 1)} s`,
    failed: problem,
  }[state];
  return (
    <div class={tableCss["measuring"]}>
      <progress max={RUNS} value={answered} aria-label="Measured" />
      <p class="number">{text}</p>
      <p class="unseen" role="status">
        {state === "running" ? "Measuring" : text}
      </p>
    </div>
  );
}

function Found({ rows, done }: { rows: readonly Row[]; done: boolean }) {
  if (!done) return <p>Measuring …</p>;
  const better = rows.filter((row) => median(row.found) > row.paper);
  const never = rows.filter((row) => row.centred !== null && row.centred >= 0.4999).map((row) => row.size);
  const missed = rows.filter((row) => median(row.found) > 0.5);
  return (
    <>
      <p>
        At {better.length === rows.length ? "all" : `${better.length} of the`} four resolutions a plain index
        buffer sees the gap at scales nearer to ½ than the paper’s did.
      </p>
      {missed.length > 0 && (
        <p>
          At {missed.map((row) => row.size).join(" and ")} pixels the points are too few: those pixels that
          both pieces hold are missed by one of them.
        </p>
      )}
      <p>
        With the window exactly in the middle of the gasket, as an image usually has it,{" "}
        {never.length > 0 ? (
          <>
            {never.join(", ")} pixels a side never see it whole: its pieces touch exactly on borders between
            pixels, and only when they overlap, beyond ½, do they share one. The table’s windows are shifted
            off the middle.
          </>
        ) : (
          <>it says connected from {rows.map((row) => fixed(row.centred ?? 0, 4)).join(", ")} on.</>
        )}
      </p>
    </>
  );
}

interface Measurement {
  all: readonly Search[];
  state: "running" | "stopped" | "done" | "failed";
  answered: number;
  seconds: number;
  exact: number | null;
  problem: string;
  stop: () => void;
  again: () => void;
}

function useMeasurement(points: number): Measurement {
  const channel = useChannel();
  const exactChannel = useChannel();
  const [round, setRound] = useState(0);
  const [exact, setExact] = useState<number | null>(null);
  const [now, setNow] = useState({ all: [] as Search[], answered: 0, seconds: 0, problem: "" });
  const [state, setState] = useState<Measurement["state"]>("running");
  const host = useValue(epoch);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another round or another host measures anew
  useEffect(() => {
    const all = searches();
    const started = performance.now();
    let answered = 0;
    const tell = (problem = "") =>
      setNow({ all, answered, seconds: (performance.now() - started) / 1000, problem });
    setState("running");
    tell();
    submit(exactJob(exactChannel, EPSILON, setExact));
    submit(
      measureJob(
        channel,
        all,
        { points, seed: SEED },
        {
          progress() {
            answered++;
            tell();
          },
          done: () => setState("done"),
          fail(message) {
            cancel(channel);
            tell(message);
            setState("failed");
          },
        },
      ),
    );
  }, [channel, exactChannel, points, round, host]);
  return {
    ...now,
    state,
    exact,
    stop() {
      cancel(channel);
      setState("stopped");
    },
    again: () => setRound(round + 1),
  };
}

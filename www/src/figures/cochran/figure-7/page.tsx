import { useMemo } from "preact/hooks";
import { nearestWords } from "#format/nearness";
import { fixed } from "#format/numbers";
import { UNIT } from "#geometry/boxes";
import { boxOfPoints } from "#geometry/point-box";
import { Button } from "#ui/controls/Button";
import { Switch } from "#ui/controls/Switch";
import type { Collage, FitFigures } from "#workers/fit/curve";
import { numbersPerMap } from "#workers/fit/map-numbers";
import { Choice } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { fitHref } from "../../kit/frame/studio-link";
import { Table } from "../../kit/frame/table";
import tableCss from "../../kit/frame/table.module.css";
import { type Field, flag, only, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import {
  type CurveState,
  FEATURES,
  MAPS,
  type Maps,
  polylinesOf,
  useCollages,
  useCurveFit,
  useLeaf,
} from "./leaf-fits";
import { Closer, CollagePanel, OUTLINE, type PanelProps } from "./leaf-panels";
import { type OutlineLine, OutlineView } from "./outline-view";
import css from "./page.module.css";

const SEED = 1;
const MOST_SEED = 9999;

/** What stands in its address. */
export const STATE = {
  seed: kept(SEED, whole(1, MOST_SEED)),
  tied: kept(false, flag),
  apart: kept(false, flag),
  maps: kept<Maps>(29, only(whole(1, 99), (count) => MAPS.some((one) => one === count)) as Field<Maps>),
};

/** A leaf, the paper's two fits of it, and a closed curve of as many numbers. */
export function Page(heading: Heading) {
  const [seed, setSeed] = useKept("seed", ...STATE.seed);
  const [tied, setTied] = useKept("tied", ...STATE.tied);
  const [separable, setSeparable] = useKept("apart", ...STATE.apart);
  const [maps, setMaps] = useKept("maps", ...STATE.maps);
  const perMap = numbersPerMap(separable);
  const numbers = perMap * maps;
  const { leaf, problem } = useLeaf(seed);
  const collages = useCollages(leaf, tied, separable);
  const fit = useCurveFit(leaf, numbers);
  const box = useMemo(() => boxOfPoints(leaf?.points ?? []) ?? UNIT, [leaf]);
  const collage = collages?.[MAPS.indexOf(maps)] ?? null;
  // Written when it comes to rest: it takes a while.
  const curve = fit.done?.curve ?? (fit.state === "stopped" ? fit.reached?.curve : undefined);
  const href = useMemo(
    () =>
      curve
        ? fitHref({ mode: "outline", numbers, curve: { name: "Grown maple leaf", curve } })
        : fitHref({ mode: "outline", numbers }),
    [curve, numbers],
  );
  return (
    <Frame
      {...heading}
      lead={
        <p>
          A maple leaf, {FEATURES} feature points on its margin, and two ways to write it down with few
          numbers. The paper replaces each stretch of the margin by the best copy of a longer stretch. Look
          closely at its fits: the copies do not meet, and the red ticks mark the gaps. Tie their ends, and
          the gaps close while the fit gets worse. Below is Frond’s own curve of as many numbers: its edges
          run from knot to knot, so it cannot come apart.
        </p>
      }
      found={<Found maps={maps} collages={collages} fit={fit} tied={tied} />}
      parameters={[
        { name: "Leaf (reconstructed)", value: `a sugar maple’s, grown by program, seed ${seed}` },
        { name: "Points of its margin", value: leaf ? String(leaf.points.length / 2) : "…" },
        { name: "Feature points", value: `${FEATURES}, by polyline splitting` },
        {
          name: "Ranges",
          symbol: "M",
          value: "5 intervals each with 52 maps (260 points), 9 with 29",
        },
        { name: "Domains", value: "twice as long, from where a range begins: an RFIF" },
        { name: "Bound of the factors", value: "0.95, by constrained least squares" },
        { name: "A map costs", value: `${perMap} numbers (eq ${separable ? 8 : 9})` },
        { name: "A knot costs", value: "2 numbers, a copied edge 2 more" },
      ]}
      captions={[
        "Figure 7: Maple leaf (top) and FIF approximations with 52 control vertices (left) and 29 control vertices (right).",
      ]}
      reconstructed="The paper prints its leaf as a picture, without numbers, and does not print its maps. This is another maple leaf, grown by program, with as many feature points; the lengths of ranges and domains are reconstructed from the text of section 3.2."
      differs={
        <>
          The paper does not say that its unconstrained fit leaves gaps, nor what it costs: 52 maps of 10
          numbers are 520 numbers, and the polygon of its {FEATURES} feature points is 522. At the paper’s own
          size nothing is saved.
        </>
      }
      studio={{ href, label: "Open in the Fit tool" }}
    >
      <div class={layout["controls"]}>
        <Switch checked={tied} onChange={setTied}>
          Tie the ends of copies
        </Switch>
        <Switch checked={separable} onChange={setSeparable}>
          Copy x and y apart (eq 8)
        </Switch>
        <Button icon="reset" onClick={() => setSeed((seed % MOST_SEED) + 1)}>
          Grow another leaf
        </Button>
      </div>
      {problem !== null && (
        <p class={layout["missing"]} role="alert">
          {problem}
        </p>
      )}
      <div class={css["leaves"]}>
        <Panel name="The leaf" words={`${FEATURES} feature points`}>
          <OutlineView
            box={box}
            label={`The leaf with its ${FEATURES} feature points`}
            lines={
              leaf
                ? [
                    { points: leaf.points, colour: "ink", width: 1, closed: true, filled: true },
                    { points: leaf.features, colour: 5, dots: 4 },
                  ]
                : []
            }
          />
        </Panel>
        {MAPS.map((count, i) => (
          <CollagePanel
            key={count}
            maps={count}
            collage={collages?.[i] ?? null}
            leaf={leaf?.points ?? null}
            box={box}
            tied={tied}
            separable={separable}
          />
        ))}
      </div>
      <div class={layout["controls"]}>
        <Choice
          label="Compare at"
          options={MAPS.map((count) => ({
            value: String(count),
            label: `${perMap * count} numbers`,
          }))}
          value={String(maps)}
          onChange={(value) => setMaps(value === "52" ? 52 : 29)}
        />
      </div>
      <div class={layout["fit-columns"]}>
        <CurvePanel fit={fit} leaf={leaf?.points ?? null} box={box} numbers={numbers} />
        <div class={css["leaf-side"]}>
          <Errors maps={maps} collage={collage} fit={fit} />
          <Closer maps={maps} collage={collage} leaf={leaf?.points ?? null} box={box} />
        </div>
      </div>
    </Frame>
  );
}

interface CurvePanelProps extends PanelProps {
  fit: CurveState;
  numbers: number;
}

function CurvePanel({ fit, leaf, box, numbers }: CurvePanelProps) {
  const shown = fit.done ?? fit.reached;
  const lines = useMemo(
    (): OutlineLine[] => [
      ...(leaf ? [{ points: leaf, ...OUTLINE }] : []),
      ...(shown ? [{ points: shown.points, colour: 0, width: 1.5, closed: true, filled: true }] : []),
    ],
    [leaf, shown],
  );
  const share = fit.done ? 1 : (fit.reached?.share ?? 0);
  const rms = fit.done?.figures.rms ?? fit.reached?.rms ?? null;
  const words =
    fit.state === "failed"
      ? fit.problem
      : fit.state === "done"
        ? "done"
        : fit.state === "stopped"
          ? "stopped: the best so far"
          : `${Math.round(100 * share)}%, the best so far`;
  return (
    <Panel
      name="Frond’s closed curve"
      words={`${numbers} numbers, no gaps`}
      caption={
        <>
          <div class={tableCss["measuring"]}>
            <progress max={1} value={share} aria-label="Fitted" />
            {fit.state === "running" ? (
              <Button onClick={fit.stop}>Stop</Button>
            ) : (
              <Button icon="reset" onClick={fit.again}>
                Fit again
              </Button>
            )}
          </div>
          <p class="number">{words}</p>
          <p class="unseen" role="status">
            {fit.state === "running" ? "Fitting" : words}
          </p>
        </>
      }
    >
      <OutlineView
        box={box}
        lines={lines}
        label={`Frond’s closed curve of ${numbers} numbers${rms === null ? "" : `, ${fixed(rms, 3)}% off`}`}
      />
    </Panel>
  );
}

interface ErrorsProps {
  maps: Maps;
  collage: Collage | null;
  fit: CurveState;
}

/** How far each is from the leaf, in percent of the diagonal. */
function Errors({ maps, collage, fit }: ErrorsProps) {
  const done = fit.done;
  const rows: readonly (RowOf & { key: string })[] = [
    {
      key: "collage",
      name: `The paper, ${maps} maps`,
      numbers: collage?.numbers,
      gap: collage?.widest,
      figures: collage?.figures,
    },
    ...polylinesOf(fit.rivals).map(({ name, fit: line }) => ({
      key: name,
      name,
      numbers: line?.numbers,
      gap: 0,
      figures: line?.figures,
    })),
    {
      key: "closed",
      name: "Frond’s closed curve",
      numbers: done ? 2 * (done.curve.knots.length + done.curve.edges.filter(Boolean).length) : undefined,
      gap: 0,
      figures: done?.figures,
    },
  ];
  return (
    <Table
      caption="Errors in percent of the diagonal"
      wide="Errors"
      columns={["Fit", "numbers", "RMS", "farthest", "widest gap", "roughness"]}
    >
      <tbody>
        {rows.map(({ key, ...row }) => (
          <ErrorRow key={key} {...row} />
        ))}
      </tbody>
    </Table>
  );
}

interface RowOf {
  name: string;
  numbers: number | undefined;
  gap: number | undefined;
  figures: FitFigures | undefined;
}

function ErrorRow({ name, numbers, gap, figures }: RowOf) {
  return (
    <tr>
      <th scope="row">{name}</th>
      <td>{numbers ?? "…"}</td>
      <td class={tableCss["strong"]}>{figures ? fixed(figures.rms, 3) : "…"}</td>
      <td>{figures ? fixed(figures.hausdorff) : "…"}</td>
      <td>{gap === undefined ? "…" : gap > 1e-6 ? fixed(gap) : "none"}</td>
      <td>{figures ? fixed(figures.fitSlope, 3) : "…"}</td>
    </tr>
  );
}

interface FoundProps {
  maps: Maps;
  collages: readonly Collage[] | null;
  fit: CurveState;
  tied: boolean;
}

function Found({ maps, collages, fit, tied }: FoundProps) {
  const collage = collages?.[MAPS.indexOf(maps)];
  const lines = polylinesOf(fit.rivals).flatMap(({ name, fit: line }) =>
    line ? { name, rms: line.figures.rms } : [],
  );
  if (!collage || lines.length < 2 || !fit.done) return <p>Fitting …</p>;
  const nearest = Math.min(...lines.map(({ rms }) => rms));
  const others = [...lines, { name: "The paper’s fit", rms: collage.figures.rms }];
  const beside = nearestWords(fit.done.figures.rms, others);
  return (
    <p>
      With {collage.numbers} numbers the paper’s fit{tied ? ", its ends tied," : ""} is{" "}
      {fixed(collage.figures.rms / nearest, 1)} times as far from this leaf as the nearer of two polylines of
      as many. Frond’s curve: {beside.charAt(0).toLowerCase() + beside.slice(1)} Roughness is the box
      dimension between 1/64 and 1/256 of the diagonal: {fixed(collage.figures.outlineSlope, 3)} for the leaf
      itself, {fixed(collage.figures.fitSlope, 3)} for the paper’s fit, {fixed(fit.done.figures.fitSlope, 3)}{" "}
      for Frond’s curve.
    </p>
  );
}

import { useEffect, useMemo } from "preact/hooks";
import type { LocusResult } from "#compute/results";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { isBroken } from "#geometry/states";
import type { MapRow, PathPlan } from "#wasm/api";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { PointControls } from "../../kit/frame/point-controls";
import { drawn, preset, studioHref } from "../../kit/frame/studio-link";
import { VerdictChip } from "../../kit/frame/verdict";
import { Square } from "../../kit/locus/locus-square";
import { shareWords } from "../../kit/maps/breakage";
import { boxAround, mapsAt, STRAIGHT } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { Picture } from "../../kit/picture/picture";
import { point as pointOf } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { useValue, useVerdict } from "../../kit/workers";
import { chart, dragon, ends, followChart } from "../dragon/dragon";
import { DragonChoice, dragonParameters, WHY_DRAGON } from "../dragon/dragon-choice";
import { dragonWords } from "../dragon/film";
import css from "./page.module.css";

/** What stands in its address. */
export const STATE = {
  point: kept<Uv>([0.5, 0.5], pointOf(-1, 2, 3)),
};

/** The connectedness locus of dragon and gasket. */
export function Page(heading: Heading) {
  useEffect(followChart, []);
  const [point, setPoint] = useKept("point", ...STATE.point);
  const { field, plan, problem } = chart.value;
  const pair = useValue(ends);
  const maps = useMemo(() => mapsAt(pair, point), [pair, point]);
  const judged = useVerdict(maps);
  const box = useMemo(() => boxAround([pair.from, pair.to, maps]), [pair, maps]);
  const lines = [
    { name: "straight", points: STRAIGHT, dashed: true },
    ...(plan ? [{ name: "planned", points: plan.points }] : []),
  ];
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Every point of the square is one shape: <Formula>u</Formula> says how far its maps have turned and
          stretched from the dragon’s (A) to the gasket’s (B), <Formula>v</Formula> how far they have moved.
          White means that no gap is seen at 1/600. A morph is a way from A to B: the straight one crosses the
          dark, the other goes round. Drag the ring to see the shapes.
        </p>
      }
      found={<Found field={field} plan={plan} />}
      parameters={[
        ...dragonParameters(),
        { name: "Domain", symbol: tex`(u, v)`, value: [tex`[-1, 2] \times [-1, 2]`] },
        { name: "Samples", value: "253 × 253" },
        { name: "Resolution of the verdicts", symbol: "ε", value: "1/600 of the shape" },
        {
          name: "The ring",
          symbol: tex`(u, v)`,
          value: [tex`(${fixed(point[0], 3)}, ${fixed(point[1], 3)})`],
        },
      ]}
      captions={[
        "Figure 7: The connectedness locus for the Dragon-to-Gasket interpolation. White indicates parameters of path-connected attractors.",
      ]}
      reconstructed={WHY_DRAGON}
      studio={{
        href: studioHref({
          a: preset(dragon.value),
          b: preset("gasket"),
          t: 0.5,
          ...(plan ? { path: drawn(plan.points) } : {}),
        }),
      }}
    >
      <DragonChoice />
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <div>
          <div class={css["axes"]}>
            <Ticks axis="v" />
            <Square
              field={field}
              label="The connectedness locus over u and v from −1 to 2, with the straight and the planned path from (0, 0) to (1, 1)."
              lines={lines}
              point={point}
              onMove={setPoint}
            />
            <Ticks axis="u" />
          </div>
          <Legend progress={field?.progress ?? 0} problem={problem} />
        </div>
        <Here maps={maps} box={box} point={point} judged={judged} onMove={setPoint} />
      </div>
    </Frame>
  );
}

const AXES = [
  { label: "turn and stretch", symbol: "u", name: "u, turn and stretch" },
  { label: "move", symbol: "v", name: "v, move" },
] as const;

interface HereProps {
  maps: MapRow[];
  box: ReturnType<typeof boxAround>;
  point: Uv;
  judged: ReturnType<typeof useVerdict>;
  onMove: (point: Uv) => void;
}

/** The shape at the ring, and the sliders that move it. */
function Here({ maps, box, point, judged, onMove }: HereProps) {
  const [u, v] = point;
  const answer = judged?.answer ?? null;
  return (
    <div class={`${layout["panel"]} ${css["here"]}`}>
      <Picture
        maps={maps}
        box={box}
        label={`The shape at u = ${fixed(u)}, v = ${fixed(v)}: ${verdictPhrase(answer)}`}
      />
      <VerdictChip answer={answer} stale={judged?.maps !== maps} />
      <PointControls
        axes={AXES}
        range={[-1, 2]}
        point={point}
        said={(name, value) => `${name} = ${fixed(value)}: ${verdictPhrase(answer)}`}
        onMove={onMove}
      />
    </div>
  );
}

function Ticks({ axis }: { axis: "u" | "v" }) {
  return (
    <div class={`${css["axis"]} ${css[axis]}`} aria-hidden="true">
      {[-1, 0, 1, 2].map((at) => (
        <span key={at} style={{ "--at": `${(100 * (at + 1)) / 3}%` }}>
          {fixed(at, 0)}
        </span>
      ))}
      <em>{axis}</em>
    </div>
  );
}

function Legend({ progress, problem }: { progress: number; problem: string | null }) {
  return (
    <ul class={layout["key"]} aria-label="Key">
      <li>
        <i class={`${css["box"]} ${css["holds"]}`} /> no gap wider than 1/600
      </li>
      <li>
        <i class={`${css["box"]} ${css["broken"]}`} /> in pieces, darker the wider the gap
      </li>
      <li>
        <i class={`${css["line"]} ${css["dashed"]}`} /> Figure 5
      </li>
      <li>
        <i class={css["line"]} /> Figure 6
      </li>
      <li class="number">
        {problem ?? (progress < 1 ? `${Math.round(100 * progress)}% computed` : "all computed")}
      </li>
    </ul>
  );
}

function Found({ field, plan }: { field: LocusResult | null; plan: PathPlan | null }) {
  const white = useMemo(() => (field?.progress === 1 ? 1 - share(field.state) : null), [field]);
  if (white === null || plan === null) return <p>The square is being filled in …</p>;
  return (
    <p>
      {shareWords(white)} of the square is white for {dragonWords()} and the gasket. The gasket, B, lies on
      its very edge.{" "}
      {plan.holds
        ? "A and B hang together in it: there is a way round."
        : "Dark stripes part A from B, so every way breaks somewhere. For the mirror image of this dragon there is a way round: how a shape is written decides what it can become."}
    </p>
  );
}

/** The part of the samples that is broken. */
function share(state: Uint8Array): number {
  let broken = 0;
  for (const s of state) if (isBroken(s)) broken++;
  return broken / state.length;
}

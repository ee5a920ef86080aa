import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { loadProof, prover } from "#wasm/proof";
import { Plot } from "../../kit/chart/plot";
import { QUARTERS } from "../../kit/chart/scale";
import { barnsley, type Round } from "../../kit/connectedness/barnsley";
import { Rows } from "../../kit/connectedness/barnsley-rows";
import { SliderControl } from "../../kit/frame/control";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { studioHref } from "../../kit/frame/studio-link";
import { Chip } from "../../kit/frame/verdict";
import { dust } from "../../kit/maps/families";
import { tex } from "../../kit/notation/tex";
import { number, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import css from "./page.module.css";

const MOST_ROUNDS = 10;
const [LOWEST, HIGHEST] = [0.25, 0.55];

/** What stands in its address. */
export const STATE = {
  r: kept(0.47, number(LOWEST, HIGHEST, 3)),
  rounds: kept(2, whole(1, MOST_ROUNDS)),
};

/** What must be there before it is shown. */
export const needs = [loadProof];

/** Barnsley's object test on a dust of two maps. */
export function Page(heading: Heading) {
  const [r, setR] = useKept("r", ...STATE.r);
  const [wanted, setWanted] = useKept("rounds", ...STATE.rounds);
  // The test ends with its first proof, so there may be fewer rounds than were asked for.
  const rounds = useMemo(() => barnsley(r, wanted), [r, wanted]);
  const last = rounds.at(-1);
  const ended = last?.apart === true;
  const step = () => setWanted(Math.min(MOST_ROUNDS, rounds.length + 1));
  return (
    <Frame
      {...heading}
      lead={
        <p>
          Two maps shrink the line by <Formula>r</Formula>, one towards 0 and one towards 1. Each iteration
          stands a few points in for the two pieces; no part of a piece is farther from them than the coloured
          bars reach. Once the bars of the two colours part, the pieces cannot meet: that is a proof. Bars
          that still overlap prove nothing, and from <Formula tex={tex`r = \frac{1}{2}`} /> on they always do.
        </p>
      }
      found={<Found r={r} />}
      parameters={[
        { name: "Maps", value: [tex`f_1(x) = r x`, tex`f_2(x) = r x + 1 - r`] },
        { name: "Scale, which is s", symbol: "r", value: fixed(r, 3) },
        { name: "Radius that holds the attractor", symbol: "R", value: "1, about the origin" },
        { name: "First set", symbol: tex`\tilde{A}`, value: "{0}" },
        { name: "Iterations done", value: String(rounds.length) },
        { name: "Points now", value: String(2 * (last?.pieces[0].length ?? 0)) },
        { name: "Least distance", symbol: "d", value: fixed(last?.distance ?? 0, 5) },
        { name: "Bound", symbol: tex`2 s^{n+1} R`, value: fixed(last?.bound ?? 0, 5) },
      ]}
      captions={["Figure 1: Object-based connectedness algorithm [Barnsley, 1988]."]}
      reconstructed="The algorithm is the paper’s, line by line. It prints no example, so the dust is chosen here: the simplest family that falls apart at a known place."
      studio={{ href: href(r) }}
    >
      <div class={layout["controls"]}>
        <SliderControl
          label="Scale"
          name="Scale r"
          symbol="r"
          range={[LOWEST, HIGHEST]}
          step={0.005}
          value={r}
          text={fixed(r, 3)}
          valueText={fixed(r, 3)}
          onChange={setR}
        >
          <span
            class={css["slider-mark"]}
            style={{ left: `${(100 * (0.5 - LOWEST)) / (HIGHEST - LOWEST)}%` }}
          />
        </SliderControl>
        <div class={layout["buttons"]}>
          <Button kind="primary" onClick={step} disabled={ended || rounds.length >= MOST_ROUNDS}>
            Next iteration
          </Button>
          <Button icon="reset" onClick={() => setWanted(1)} disabled={rounds.length === 1}>
            Begin again
          </Button>
        </div>
      </div>
      <div aria-live="polite">
        <Answer last={last} r={r} />
      </div>
      <div class={layout["two-columns"]}>
        <Rows rounds={rounds} r={r} />
        <Curves r={r} rounds={rounds} />
      </div>
    </Frame>
  );
}

function Answer({ last, r }: { last: Round | undefined; r: number }) {
  if (last?.apart) {
    return <Chip tone="broken" text="In pieces" aside={`by the bounds of iteration ${last.n + 1}`} />;
  }
  const done = (last?.n ?? -1) + 1;
  return (
    <Chip
      tone="unknown"
      text={done >= MOST_ROUNDS ? "Nothing proved" : "Nothing proved yet"}
      aside={
        r < 0.5 ? `after ${done} of at most ${MOST_ROUNDS}` : "nor will it be: from ½ on the pieces meet"
      }
    />
  );
}

function Curves({ r, rounds }: { r: number; rounds: readonly Round[] }) {
  return (
    <Plot
      label={`Distance and bound by iteration. The distance falls towards ${fixed(Math.max(0, 1 - 2 * r), 3)}, the bound towards 0.`}
      x={{ name: "n", min: 0, max: MOST_ROUNDS - 1, ticks: [0, 3, 6, 9] }}
      y={{ name: "distance", ...QUARTERS }}
      series={[
        {
          name: "2sⁿ⁺¹R",
          points: rounds.map((round) => [round.n, round.bound]),
          colour: 5,
          dashed: true,
          dots: true,
          nameAt: 0,
          raise: -18,
        },
        { name: "d", points: rounds.map((round) => [round.n, round.distance]), colour: 1, dots: true },
      ]}
      {...(r < 0.5 ? { level: { at: 1 - 2 * r, name: `the gap itself, ${fixed(1 - 2 * r, 3)}` } } : {})}
    />
  );
}

/** The same question put to the package. */
function Found({ r }: { r: number }) {
  const test = useMemo(() => prover().barnsleyTest({ maps: dust(r) }, { iterations: MOST_ROUNDS }), [r]);
  const truth = useMemo(() => prover().connectedness({ maps: dust(r) }, { epsilon: 1e-6 }), [r]);
  const middle = test.disconnected
    ? `proves it after ${test.iterations} iteration${test.iterations === 1 ? "" : "s"}`
    : "proves nothing either";
  const search = {
    connected: "proves the dust to be in one piece (it is the whole line from 0 to 1)",
    touching: "sees no gap above a millionth of its diameter",
    disconnected: `proves a gap of ${fixed(truth.gap.lower, 4)}; by the formula it is 1 − 2r = ${fixed(1 - 2 * r, 4)}`,
    undecided: "gives up",
    "no-attractor": "finds no attractor",
  }[truth.verdict];
  return (
    <p>
      How soon the test sees a gap depends on where it starts. From the origin, as printed, the disc that
      holds the dust must have <Formula tex={tex`R = 1`} />. Frond’s own test starts in the middle, where half
      of that will do, and {middle} at <Formula tex={tex`r = ${fixed(r, 3)}`} />. Its search through pairs of
      pieces {search}.
    </p>
  );
}

function href(r: number): string {
  const a = { name: "Dust that has closed", maps: dust(HIGHEST) };
  const b = { name: "Cantor dust", maps: dust(LOWEST) };
  return studioHref({ a, b, t: (HIGHEST - r) / (HIGHEST - LOWEST) });
}

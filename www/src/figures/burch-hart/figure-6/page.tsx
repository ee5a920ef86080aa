import { useEffect } from "preact/hooks";
import { fixed } from "#format/numbers";
import { shareWords as gapWords } from "#format/verdict";
import type { PathPlan } from "#wasm/api";
import { Formula } from "../../kit/frame/formula";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { drawn, preset, studioHref } from "../../kit/frame/studio-link";
import { Chip } from "../../kit/frame/verdict";
import { Square } from "../../kit/locus/locus-square";
import { type Breakage, shareWords, stretchWords } from "../../kit/maps/breakage";
import { STRAIGHT } from "../../kit/maps/morphs";
import { tex } from "../../kit/notation/tex";
import { useTime } from "../../kit/time/time";
import { SAMPLES } from "../../kit/workers";
import { chart, dragon, followChart } from "../dragon/dragon";
import { DragonChoice, dragonParameters, WHY_DRAGON } from "../dragon/dragon-choice";
import { dragonWords, Film, useBroken } from "../dragon/film";
import filmCss from "../dragon/film.module.css";

/** Dragon to gasket along a path through the locus. */
export function Page(heading: Heading) {
  useEffect(followChart, []);
  const time = useTime(0.5);
  const { plan, field, problem } = chart.value;
  const straight = useBroken(STRAIGHT);
  const led = useBroken(plan?.points ?? null);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The same two shapes. Turning and moving need not go in step: <Formula>u</Formula> turns and
          stretches the maps, <Formula>v</Formula> moves them, and a path on the map of Figure 7 says how far
          each has come. Frond looks for one on which no gap is seen, or else for the one whose widest gap is
          least.
        </p>
      }
      found={<Found plan={plan} straight={straight} led={led} />}
      parameters={[
        ...dragonParameters(),
        { name: "Path", symbol: tex`(u, v)`, value: plan ? pathWords(plan) : "being planned" },
        { name: "Locus it was planned on", value: "253 × 253 samples, checked in between" },
        { name: "Resolution of the verdicts", symbol: "ε", value: "1/600 of the shape" },
      ]}
      captions={["Figure 6: Polar interpolation of IFS attractors avoiding disconnectedness."]}
      reconstructed={`${WHY_DRAGON} The paper shows its path as a line in its Figure 7, without numbers; this one is planned.`}
      studio={{
        href: studioHref({
          a: preset(dragon.value),
          b: preset("gasket"),
          t: time.t,
          ...(plan ? { path: drawn(plan.points) } : {}),
        }),
      }}
    >
      <DragonChoice />
      {plan ? (
        <Film
          name="Figure 6"
          points={plan.points}
          time={time}
          broken={led}
          beside={(at) => (
            <Square
              field={field}
              label={`The path on the connectedness locus; the morph is at u = ${fixed(at[0])}, v = ${fixed(at[1])}.`}
              lines={[{ name: "planned", points: plan.points }]}
              point={at}
            />
          )}
        />
      ) : (
        <div class={`${layout["panel"]} ${filmCss["film-picture"]} ${filmCss["waiting"]}`}>
          <Chip
            tone="unknown"
            text={problem ?? "Planning the path …"}
            aside={problem === null ? `${Math.round(100 * (field?.progress ?? 0))}% of the locus is in` : ""}
          />
        </div>
      )}
    </Frame>
  );
}

function pathWords(plan: PathPlan): string {
  return plan.points.map(([u, v]) => `(${fixed(u)}, ${fixed(v)})`).join(" ");
}

interface FoundProps {
  plan: PathPlan | null;
  straight: Breakage | null;
  led: Breakage | null;
}

function Found({ plan, straight, led }: FoundProps) {
  if (!plan || !straight || !led) return <p>Looking for a path, and at {SAMPLES} moments of it …</p>;
  return (
    <p>
      From {dragonWords()} the straight way is broken for {shareWords(straight.share)} of its length.{" "}
      {led.share === 0 ? (
        <>
          On this path of {plan.points.length - 2} waypoints none of {SAMPLES} moments is
          {led.hidden > 0 && `, though ${led.hidden} are proved to be in pieces by gaps finer than 1/600`}.
        </>
      ) : (
        <>
          {plan.holds
            ? "Nearly all of this path holds:"
            : "Frond finds no path in the square that holds together all the way. On this one,"}{" "}
          {shareWords(led.share)} is broken (t = {stretchWords(led.stretches)})
          {plan.holds
            ? ", by gaps only just wider than ε."
            : `, by at most ${gapWords(plan.gap)} of the diameter: the least of all ways it found. The paper’s words are “avoid becoming disconnected when possible”.`}
        </>
      )}
    </p>
  );
}

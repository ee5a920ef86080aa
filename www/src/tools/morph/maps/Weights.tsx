import { areaShares } from "#document/area-shares";
import { ranks } from "#document/morph";
import { announce } from "#document/notice";
import { edit, endGesture, scene } from "#document/scene";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Fold } from "#ui/panel/Fold";
import { type End, nameOf } from "../changes";
import { colouring, shapes } from "../parts";
import { Swatch } from "../shapes/Swatch";
import { setWeights } from "./changes";
import css from "./weights.module.css";

const MOST = 1e6;

/** How often the chaos game takes each map. */
export function Weights({ target }: { target: End }) {
  const { weights } = shapes[target].value;
  return (
    <Fold title="Weights" now={weights ? "your own" : "by area"}>
      <WeightFields target={target} />
    </Fold>
  );
}

function WeightFields({ target }: { target: End }) {
  const { maps, weights } = shapes[target].value;
  const shown = weights ?? areaShares(maps).map((share) => 100 * share);
  const sum = shown.reduce((all, weight) => all + weight, 0);
  const set = (next: number[] | undefined, said?: string) => {
    edit(
      (before) => setWeights(before, target, next),
      said === undefined ? { gesture: `weights-${target}` } : {},
    );
    if (said !== undefined) announce(said);
  };
  const change = (index: number, weight: number) => {
    const next = shown.with(index, weight);
    if (next.every((one) => one === 0)) return "One map at least has to be taken now and then.";
    set(next);
    return undefined;
  };
  return (
    <div class="stack">
      <p class="hint">
        How often the chaos game takes each map, as shares of all. They change how dense the points lie, and
        nothing else: the shape, whether it is in one piece, and the numbers of its maps stay the same. A map
        of weight 0 is never taken: the density leaves its copies out.{" "}
        <a href="#learn/e15">A lesson about them</a>
      </p>
      <ol class={css["weights"]}>
        {shown.map((weight, index) => (
          // Maps have no name but their number: it is their key.
          <li key={index} class={css["weight"]}>
            <Swatch map={index} colour={ranks[target].value[index]} />
            <NumberField
              terse
              label={`Weight of map ${index + 1}`}
              value={weight}
              min={0}
              max={MOST}
              step={1}
              digits={2}
              onChange={(next) => change(index, next)}
              onDone={endGesture}
            />
            <span class={css["share"]} aria-hidden="true">
              <span style={{ inlineSize: `${(100 * weight) / sum}%` }} />
            </span>
            <span class="number">{fixed((100 * weight) / sum, 1)}%</span>
          </li>
        ))}
      </ol>
      <div class={css["foot"]}>
        <Button
          onClick={() =>
            set(
              maps.map(() => 1),
              "All maps have the same weight.",
            )
          }
        >
          All alike
        </Button>
        <Button
          kind="quiet"
          icon="reset"
          disabled={weights === undefined}
          description="Each in proportion to the area of its copy: points fall evenly"
          onClick={() => set(undefined, `The weights of ${nameOf(target)} go by area again.`)}
        >
          By area
        </Button>
      </div>
      {colouring.value !== "density" && (
        <div class="row">
          <p class="hint">Weights are seen where the colour tells the density.</p>
          <Button
            kind="quiet"
            onClick={() => {
              edit((before) => ({ ...before, colouring: "density" }));
              announce(`The colour of ${scene.peek()[target].name} tells the density.`);
            }}
          >
            Show the density
          </Button>
        </div>
      )}
    </div>
  );
}

import { areaShares } from "#document/area-shares";
import { ranks } from "#document/morph";
import { announce } from "#document/notice";
import { edit, endGesture, scene } from "#document/scene";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Fold } from "#ui/panel/Fold";
import { colouring, shapes } from "../document-signals";
import { type End, nameOf } from "../edits";
import { Swatch } from "../shapes/Swatch";
import { setWeights } from "./map-edits";
import * as messages from "./messages";
import css from "./weights.module.css";

const MOST = 1e6;

/** How often the chaos game takes each map. */
export function Weights({ target }: { target: End }) {
  const { weights } = shapes[target].value;
  return (
    <Fold title={messages.weights} now={weights ? messages.custom : messages.byArea}>
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
    if (next.every((one) => one === 0)) return messages.atLeastOneMap;
    set(next);
    return undefined;
  };
  return (
    <div class="stack">
      <p class="hint">
        {messages.howOftenChaosGame} <a href="#learn/e15">{messages.lessonOnWeights}</a>
      </p>
      <ol class={css["weights"]}>
        {shown.map((weight, index) => (
          // Maps have no name but their number: it is their key.
          <li key={index} class={css["weight"]}>
            <Swatch map={index} colour={ranks[target].value[index]} />
            <NumberField
              terse
              label={messages.weightOf(index + 1)}
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
              messages.allMapsHaveSame,
            )
          }
        >
          {messages.equal}
        </Button>
        <Button
          kind="quiet"
          icon="reset"
          disabled={weights === undefined}
          description={messages.eachWeightProportionalTo}
          onClick={() => set(undefined, messages.weightsByArea(nameOf(target)))}
        >
          {messages.byArea2}
        </Button>
      </div>
      {colouring.value !== "density" && (
        <div class="row">
          <p class="hint">{messages.weightsOnlyShowWhen}</p>
          <Button
            kind="quiet"
            onClick={() => {
              edit((before) => ({ ...before, colouring: "density" }));
              announce(messages.nowDensity(scene.peek()[target].name));
            }}
          >
            {messages.colourByDensity}
          </Button>
        </div>
      )}
    </div>
  );
}

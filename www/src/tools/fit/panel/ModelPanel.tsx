import { changeFit, fitDocument } from "#document/fit";
import { percent } from "#format/nearness";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { CollageOptions } from "#workers/fit/curve";
import fitCss from "../fit.module.css";
import { cutting } from "../stage/layers";
import { collage, collageOptions } from "../work/fitting";
import { prepared } from "../work/outline";
import * as messages from "./messages";
import { Within } from "./WithinPanel";

/** What the outline is fitted with. */
export function ModelPanel() {
  if (cutting.value) return null;
  const { model } = fitDocument.value;
  return (
    <section class={`${fitCss["model-panel"]} stack`} aria-label={messages.model}>
      <div class="section-head">
        <h2>{messages.method}</h2>
      </div>
      <Segmented
        label={messages.method}
        value={model}
        options={[
          {
            value: "closed",
            label: messages.closedCurveFrond,
            description: messages.knotsAndEdgesStraight,
          },
          {
            value: "spline",
            label: messages.limitedBytes,
            description: messages.cornersAndParabolasAs,
          },
          {
            value: "collage",
            label: messages.asInPaperCollage,
            description: messages.cochranHartAndFlynn,
          },
        ]}
        onChange={(next) => changeFit((now) => ({ ...now, model: next }))}
      />
      {model === "closed" ? (
        <p class="hint">{messages.everyEdgeStraightOr}</p>
      ) : model === "spline" ? (
        <Within />
      ) : (
        <Collage />
      )}
    </section>
  );
}

const PAPER: readonly number[] = [29, 52];

function Collage() {
  const now = collageOptions.value;
  const change = (by: Partial<CollageOptions>) => {
    collageOptions.value = { ...collageOptions.peek(), ...by };
  };
  const done = collage.value;
  const fresh = done !== null && done.of === prepared.value;
  return (
    <div class="stack">
      <div class="row">
        <span class={fitCss["collage-numbers"]}>
          <NumberField
            label={messages.maps}
            value={now.maps}
            min={2}
            max={400}
            whole
            onChange={(maps) => change({ maps: Math.round(maps) })}
          />
          <NumberField
            label={messages.featurePoints}
            value={now.features}
            min={8}
            max={4000}
            whole
            onChange={(features) => change({ features: Math.round(features) })}
          />
        </span>
        <span class={fitCss["paper-presets"]}>
          {PAPER.map((maps) => (
            <Button
              key={maps}
              kind="quiet"
              description={messages.mapsFrom261(maps)}
              onClick={() => change({ maps, features: 261 })}
            >
              {messages.mapsOf(maps)}
            </Button>
          ))}
        </span>
      </div>
      <ChoiceRow
        label={messages.xAndY}
        value={now.separable ? "apart" : "together"}
        options={[
          { value: "together", label: messages.together, description: messages.matrixFourNumbersEach },
          { value: "apart", label: messages.apart, description: messages.separableNumberForEach },
        ]}
        onChange={(next) => change({ separable: next === "apart" })}
      />
      <ChoiceRow
        label={messages.copiesStart}
        value={now.partitioned ? "anywhere" : "ranges"}
        options={[
          { value: "ranges", label: messages.wherePiecesDo, description: messages.recurrentRfif },
          { value: "anywhere", label: messages.anywhere, description: messages.partitionedPfif },
        ]}
        onChange={(next) => change({ partitioned: next === "anywhere" })}
      />
      <Switch checked={now.tied} description={messages.endsInPaperFree} onChange={(tied) => change({ tied })}>
        {messages.tieEndsPieces}
      </Switch>
      {fresh && (
        <p class="notes" data-testid="gaps">
          {done.fit.widest > 1e-6
            ? messages.piecesDoNotMeet(percent(done.fit.widest), percent(done.fit.mean))
            : messages.allPiecesMeetThere}
        </p>
      )}
    </div>
  );
}

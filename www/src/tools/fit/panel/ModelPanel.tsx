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
import { Within } from "./WithinPanel";

/** What the outline is fitted with. */
export function ModelPanel() {
  if (cutting.value) return null;
  const { model } = fitDocument.value;
  return (
    <section class={`${fitCss["model-panel"]} stack`} aria-label="Model">
      <div class="section-head">
        <h2>Fitted with</h2>
      </div>
      <Segmented
        label="Fitted with"
        value={model}
        options={[
          {
            value: "closed",
            label: "Closed curve (Frond)",
            description: "Knots, and edges that are straight or copies of arcs: closed by construction",
          },
          {
            value: "spline",
            label: "Within bytes",
            description: "Corners and parabolas, as near as so many bytes allow",
          },
          {
            value: "collage",
            label: "As in the paper (collage)",
            description: "Cochran, Hart and Flynn, section 3.2",
          },
        ]}
        onChange={(next) => changeFit((now) => ({ ...now, model: next }))}
      />
      {model === "closed" ? (
        <p class="hint">
          Every edge is straight, or a smaller copy of another part of the outline. It has no gaps, however
          rough it is.
        </p>
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
            label="Maps"
            value={now.maps}
            min={2}
            max={400}
            whole
            onChange={(maps) => change({ maps: Math.round(maps) })}
          />
          <NumberField
            label="Feature points"
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
              description={`${maps} maps from 261 feature points, as in Fig 7`}
              onClick={() => change({ maps, features: 261 })}
            >
              {`${maps} maps`}
            </Button>
          ))}
        </span>
      </div>
      <ChoiceRow
        label="x and y"
        value={now.separable ? "apart" : "together"}
        options={[
          { value: "together", label: "together", description: "A matrix of four numbers each (eq 9)" },
          { value: "apart", label: "apart", description: "Separable: a number for each coordinate (eq 8)" },
        ]}
        onChange={(next) => change({ separable: next === "apart" })}
      />
      <ChoiceRow
        label="Copies begin"
        value={now.partitioned ? "anywhere" : "ranges"}
        options={[
          { value: "ranges", label: "where pieces do", description: "Recurrent: an RFIF" },
          { value: "anywhere", label: "anywhere", description: "Partitioned: a PFIF" },
        ]}
        onChange={(next) => change({ partitioned: next === "anywhere" })}
      />
      <Switch
        checked={now.tied}
        description="The paper's are free, and leave gaps"
        onChange={(tied) => change({ tied })}
      >
        Tie the ends of the pieces
      </Switch>
      {fresh && (
        <p class="notes" data-testid="gaps">
          {done.fit.widest > 1e-6
            ? `Pieces do not meet: the widest gap is ${percent(done.fit.widest)} of the size, the mean ${percent(done.fit.mean)}. They are marked in the picture.`
            : "All pieces meet: there are no gaps."}
        </p>
      )}
    </div>
  );
}

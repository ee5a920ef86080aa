import { endGesture } from "#document/scene";
import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Select } from "#ui/controls/Select";
import { IndexSelect } from "../by-hand/PieceList";
import graphCss from "../graph/graph.module.css";
import * as messages from "../messages";
import { MOST_MAPS, type Place, plainMaps, withoutPoint, withPlace, withTime } from "./model/curve";
import { change, chosenPoint, curve, maps, problem } from "./model/document";
import { EXAMPLES } from "./model/examples";
import { Pieces } from "./Pieces";
import css from "./plane.module.css";
import { outlineOf, systemOf, takeOutline, takeSystem } from "./use";

/** A curve of the plane by hand. */
export function PlanePanel() {
  return (
    <div class={graphCss["fit-graph-panel"]}>
      <section class="stack">
        <div class="section-head">
          <h2>{messages.curve2}</h2>
          <Select
            aria-label={messages.example}
            value=""
            onChange={(event) => {
              const example = EXAMPLES.find(({ id }) => id === event.currentTarget.value);
              if (example) change(() => example.make());
              event.currentTarget.value = "";
            }}
          >
            <option value="" disabled>
              {messages.examples}
            </option>
            {EXAMPLES.map(({ id, name }) => (
              <option key={id} value={id}>
                {name}
              </option>
            ))}
          </Select>
        </div>
        <p class="hint">{messages.curvePassesThroughPoints}</p>
        <Pieces />
        <PointFields />
        <Facts />
      </section>
      <UseSection />
    </div>
  );
}

/** The chosen point in numbers. */
function PointFields() {
  const { points } = curve.value;
  const index = Math.min(chosenPoint.value, points.length - 1);
  const point = points[index];
  if (!point) return null;
  const [t, x, y] = point;
  const told = (done: boolean) => (done ? undefined : (problem.peek() ?? ""));
  const move = (to: Place, axis: string) =>
    told(change((now) => withPlace(now, index, to), `point ${index} ${axis}`));
  return (
    <fieldset class={css["plane-places"]}>
      <legend class="row-name">
        {messages.point}{" "}
        <IndexSelect
          label={messages.point2}
          value={index}
          count={points.length}
          onChange={(place) => {
            chosenPoint.value = place;
          }}
        />
        <Button
          kind="quiet"
          icon="bin"
          disabled={index === 0 || index === points.length - 1 || points.length <= 3}
          onClick={() => change((now) => withoutPoint(now, index))}
        >
          {messages.remove}
        </Button>
      </legend>
      <NumberField
        label={messages.xOf(index + 1)}
        symbol="x"
        terse
        value={x}
        onChange={(next) => move([next, y], "x")}
        onDone={endGesture}
      />
      <NumberField
        label={messages.yOf(index + 1)}
        symbol="y"
        terse
        value={y}
        onChange={(next) => move([x, next], "y")}
        onDone={endGesture}
      />
      <NumberField
        label={messages.whenReached(index + 1)}
        symbol="t"
        terse
        value={t}
        onChange={(next) => told(change((now) => withTime(now, index, next), `point ${index} t`))}
        onDone={endGesture}
      />
    </fieldset>
  );
}

function Facts() {
  const { pieces } = curve.value;
  const s = maps.value?.contractivity;
  return (
    <dl class={graphCss["graph-facts"]}>
      <div title={messages.n10NumbersMapT}>
        <dt>{messages.maps}</dt>
        <dd class="number">{pieces.length}</dd>
      </div>
      <div title={messages.howMuchEachStepShrinks}>
        <dt>{messages.contractivity}</dt>
        <dd class="number">{s === undefined ? "–" : formatNumber(s, 4)}</dd>
      </div>
    </dl>
  );
}

/** Where the curve goes from here. */
function UseSection() {
  const now = maps.value;
  const plain = now && plainMaps(now);
  const rows = plain && plain.length <= MOST_MAPS ? plain : null;
  const take = (to: "a" | "b" | "bent") => {
    const system = systemOf();
    if (system) takeSystem(system, to);
    else {
      const outline = outlineOf();
      if (outline) takeOutline(outline, to);
    }
  };
  return (
    <section class="stack" aria-label={messages.use}>
      <div class="section-head">
        <h2>{messages.use}</h2>
      </div>
      <div class="row">
        <Button kind="primary" icon="arrow" disabled={!now} onClick={() => take("a")}>
          {messages.useAs}
        </Button>
        <Button disabled={!now} description={messages.becomesLastShapeMorph} onClick={() => take("b")}>
          {messages.useAsB}
        </Button>
        <Button disabled={!now} onClick={() => take("bent")}>
          {messages.deform}
        </Button>
      </div>
      <p class="hint">{rows ? messages.attractorOf(rows.length) : messages.mapsNeedTBesides}</p>
    </section>
  );
}

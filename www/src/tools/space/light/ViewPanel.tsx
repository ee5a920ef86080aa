import { computed } from "@preact/signals";
import { useState } from "preact/hooks";
import { setView, spaceView } from "#document/space/space";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import type { Point3, SpaceView } from "#wasm/api";
import * as messages from "../messages";
import { changeView, holdEye } from "../stage/actions";
import { eyeOf, LEAST_ANGLE, MOST_ANGLE, withAngle, wrapped } from "../stage/camera";
import { degrees, pointWords, radians } from "./light";
import css from "./light.module.css";

const AXES = ["x", "y", "z"] as const;
const eye = computed(() => (spaceView.value ? pointWords(eyeOf(spaceView.value)) : ""));

const ANGLES = [
  { angle: "turn", label: messages.rotationToSide },
  { angle: "tilt", label: messages.tiltUpwards },
] as const;

/** Where it is seen from, in numbers. To look is nothing to undo. */
export function ViewPanel() {
  const [problem, setProblem] = useState<string | null>(null);
  const view = spaceView.value;
  if (!view) return null;
  const problems = { id: "space-view-problem", tell: setProblem };
  const set = (part: Partial<SpaceView>) => changeView((now) => ({ ...now, ...part }));
  return (
    <section class={`${css["light-panel"]} stack`} aria-label={messages.view}>
      <div class="section-head">
        <h2>{messages.view}</h2>
        <Button kind="quiet" icon="reset" description={messages.resetView} onClick={() => setView(null)}>
          {messages.reset}
          <span class="unseen">{messages.theView}</span>
        </Button>
      </div>
      <SliderField
        digits={0}
        label={messages.angleView}
        value={degrees(view.angle)}
        min={degrees(LEAST_ANGLE)}
        max={degrees(MOST_ANGLE)}
        step={1}
        unit="°"
        words={messages.degreesHigh(Math.round(degrees(view.angle)))}
        ends={[messages.farAndFlat, messages.nearAndWide]}
        onChange={(angle) => changeView((now) => withAngle(now, radians(angle)))}
      />
      <fieldset class={css["view-numbers"]}>
        <legend>{messages.looksAt}</legend>
        {AXES.map((axis, i) => (
          <NumberField
            key={axis}
            label={messages.looksAtOf(axis)}
            symbol={axis}
            terse
            value={view.target[i] ?? 0}
            min={-1e9}
            max={1e9}
            step={0.05}
            digits={3}
            problems={problems}
            onChange={(value) =>
              set({ target: view.target.map((old, k) => (k === i ? value : old)) as Point3 })
            }
          />
        ))}
      </fieldset>
      <fieldset class={css["view-numbers"]}>
        <legend>{messages.from}</legend>
        <NumberField
          label={messages.distance}
          symbol="r"
          terse
          value={view.distance}
          min={1e-6}
          max={1e9}
          step={0.05}
          digits={3}
          problems={problems}
          onChange={(distance) => set({ distance })}
        />
        {ANGLES.map(({ angle, label }) => (
          <NumberField
            key={angle}
            label={label}
            symbol={angle}
            terse
            unit="°"
            value={degrees(view[angle])}
            step={5}
            digits={1}
            problems={problems}
            onChange={(next) => set({ [angle]: wrapped(radians(next)) })}
          />
        ))}
      </fieldset>
      <p class="hint number" data-testid="space-eye">
        {messages.eyeAt(eye.value)}
      </p>
      {problem !== null && (
        <p class="field-problem" id={problems.id} role="alert">
          {problem}
        </p>
      )}
      <Switch
        checked={view.holds === "eye"}
        description={messages.draggingTurnsHeadOtherwise}
        onChange={holdEye}
      >
        {messages.keepEyeInPlace}
      </Switch>
    </section>
  );
}

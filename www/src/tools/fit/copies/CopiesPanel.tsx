import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { SliderField } from "#ui/controls/SliderField";
import { Switch } from "#ui/controls/Switch";
import * as messages from "../messages";
import { choose, chosen, copies, copiesShown, copyWords, MOST_STEPS, steps, stepWords } from "./copies";

/** What the fit is made of: which edge is which arc, and how the curve grows out of its knots. */
export function CopiesPanel() {
  const list = copies.value;
  if (list.length === 0) return null;
  const now = list[chosen.value];
  return (
    <section class="stack" aria-label={messages.copies}>
      <div class="section-head">
        <h2>{messages.copies}</h2>
      </div>
      <Switch
        checked={copiesShown.value}
        description={messages.edgesCopySameArc}
        onChange={(on) => {
          copiesShown.value = on;
          if (on) steps.value = null;
        }}
      >
        {messages.showEdgeCopiesArc}
      </Switch>
      {copiesShown.value && now && (
        <>
          <NumberField
            label={messages.copyOf(list.length)}
            value={chosen.value + 1}
            min={1}
            max={list.length}
            whole
            onChange={(next) => choose(next - 1)}
          />
          <p class="hint" aria-live="polite" data-part="copy">
            {copyWords(now)}
          </p>
        </>
      )}
      <SliderField
        label={messages.stepsGrowth}
        value={steps.value ?? MOST_STEPS}
        max={MOST_STEPS}
        step={0.05}
        digits={2}
        words={stepWords(steps.value)}
        ends={["knots", messages.allOfIt]}
        onChange={(next) => {
          steps.value = next >= MOST_STEPS ? null : next;
          if (steps.value !== null) copiesShown.value = false;
        }}
      />
      {steps.value !== null && (
        <Button
          kind="quiet"
          onClick={() => {
            steps.value = null;
          }}
        >
          {messages.showAll}
        </Button>
      )}
    </section>
  );
}

import { endGesture } from "#document/scene";
import { NumberField } from "#ui/controls/NumberField";
import * as messages from "../../messages";
import { farthest, mesh } from "../document";
import { nudge } from "../edit";
import meshCss from "../mesh.module.css";
import { chosen, lead } from "./chosen";
import { nameOf } from "./words";

/**
 * How far the chosen handle is moved, in numbers. Several keep their distances: the numbers are those of one of them.
 */
export function HandleFields() {
  const all = chosen.value;
  const now = mesh.value;
  const [first] = all;
  if (first === undefined) return <p class={meshCss["mesh-none"]}>{messages.noHandleSelectedClick}</p>;
  const held = all.has(lead.value) ? lead.value : first;
  const far = farthest(now.box);
  const field = (axis: 0 | 1) => {
    const value = now.moves[2 * held + axis] ?? 0;
    return (
      <NumberField
        label={axis === 0 ? messages.movedRight : messages.movedUp}
        symbol={axis === 0 ? "x" : "y"}
        value={value}
        min={-far}
        max={far}
        onChange={(next) => {
          const by = next - value;
          nudge(held, axis === 0 ? [by, 0] : [0, by], `mesh field ${axis}`);
        }}
        onDone={endGesture}
      />
    );
  };
  return (
    // biome-ignore lint/a11y/useSemanticElements: a fieldset is for forms
    <div class={meshCss["mesh-fields"]} role="group" aria-label={messages.selectedHandles2}>
      <p class={meshCss["mesh-which"]}>
        {nameOf(now, held)}
        {all.size > 1 && messages.moreWithIt(all.size - 1)}
      </p>
      <div class={meshCss["mesh-numbers"]}>
        {field(0)}
        {field(1)}
      </div>
    </div>
  );
}

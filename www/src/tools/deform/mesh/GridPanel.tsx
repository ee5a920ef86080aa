import { computed } from "@preact/signals";
import { changeDeformation } from "#document/deform/bend";
import { endGesture } from "#document/scene";
import { bernstein, foldedPart, foldedWords } from "#geometry/folds";
import { LEAST_SIDE, MOST_SIDE, remesh } from "#geometry/mesh";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import type { Option } from "#ui/controls/Segmented";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { nameOf } from "../deform-text";
import * as messages from "../messages";
import { nudge, resetAll, type Symmetry, symmetry } from "./edit";
import css from "./mesh.module.css";
import meshCss from "./mesh.module.css";
import { chosen, farthest, gridShown, lead, mesh } from "./mesh-state";

const SYMMETRIES: readonly Option<Symmetry>[] = [
  { value: "off", label: messages.off, description: messages.eachHandleMovesAlone },
  { value: "sides", label: messages.leftRight, description: messages.mirroredHandleOnOther },
  { value: "levels", label: messages.upDown, description: messages.mirroredHandleAboveOr },
  { value: "point", label: messages.point, description: messages.handleAcrossCentreMoves },
];

/** What is said of a grid that is folded over. */
const folded = computed(() => {
  const { columns, rows, box, moves } = mesh.value;
  const [x0, y0, x1, y1] = box;
  const part = foldedPart(2, ([s = 0, t = 0]) => {
    const [across, up] = [bernstein(s, columns), bernstein(t, rows)];
    const to: [number, number] = [x0 + (x1 - x0) * s, y0 + (y1 - y0) * t];
    for (const [row, b] of up.entries()) {
      for (const [column, a] of across.entries()) {
        const i = 2 * (row * columns + column);
        to[0] += a * b * (moves[i] ?? 0);
        to[1] += a * b * (moves[i + 1] ?? 0);
      }
    }
    return to;
  });
  return foldedWords(part, messages.resetAll);
});

const rests = computed(() => mesh.value.moves.every((x) => x === 0));

/** The grid itself: what is chosen in numbers, how the hand edits, how many handles there are. */
export function GridPanel() {
  return (
    <section class={`${css["grid-panel"]} stack`} aria-label={messages.grid}>
      <div class="section-head">
        <h2>{messages.grid}</h2>
        <Switch
          checked={gridShown.value}
          onChange={(on) => {
            gridShown.value = on;
          }}
        >
          {messages.showGrid}
        </Switch>
      </div>
      <HandleFields />
      <ChoiceRow
        label={messages.mirror}
        name={messages.mirrorMoves}
        options={SYMMETRIES}
        value={symmetry.value}
        onChange={(next) => {
          symmetry.value = next;
        }}
      />
      <div class="row">
        <Side of={messages.columns} />
        <Side of={messages.rows} />
        <Button kind="quiet" disabled={rests.value} onClick={resetAll}>
          {messages.resetAll}
        </Button>
      </div>
      {folded.value && <p class="hint">{folded.value}</p>}
    </section>
  );
}

/** How many handles there are one way: the bend stays as near to what it was as that many allow. */
function Side({ of }: { of: "columns" | "rows" }) {
  return (
    <NumberField
      label={of === "columns" ? messages.columns2 : messages.rows2}
      value={mesh.value[of]}
      min={LEAST_SIDE}
      max={MOST_SIDE}
      step={1}
      digits={2}
      onChange={(next) => {
        if (!Number.isInteger(next)) return messages.enterWholeNumber;
        changeDeformation(
          (d) => remesh(d, of === "columns" ? next : d.columns, of === "rows" ? next : d.rows),
          { gesture: `mesh ${of}` },
        );
        return;
      }}
      onDone={endGesture}
    />
  );
}

/**
 * How far the chosen handle is moved, in numbers. Several keep their distances: the numbers are those of one of them.
 */
function HandleFields() {
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

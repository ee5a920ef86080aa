import { computed, type ReadonlySignal, type Signal } from "@preact/signals";
import { Segmented } from "#ui/controls/Segmented";
import { Term } from "#ui/terms/Term";
import type { TermName } from "#ui/terms/words";
import * as messages from "../messages";
import type { LocusStyle } from "./paint";

interface LocusHeadProps {
  id: string;
  style: Signal<LocusStyle>;
  /** What says, when the title is pressed, how the map is read. */
  term?: TermName | false;
}

/** The head of a map of where a morph holds together, with how it is shown. */
export function LocusHead({ id, style, term }: LocusHeadProps) {
  const title = messages.whereStaysInOne;
  return (
    <header class="section-head">
      <h2 id={id}>{term ? <Term name={term}>{title}</Term> : title}</h2>
      <Segmented
        label={messages.show}
        value={style.value}
        onChange={(next) => {
          style.value = next;
        }}
        options={[
          { value: "gap", label: messages.gap, description: messages.widthWidestGapBetween },
          { value: "yesno", label: messages.yesNo, description: messages.onlyWhetherStaysIn },
        ]}
      />
    </header>
  );
}

/** Which states a field shows; the same as long as they stay the same. */
export function statesIn(
  field: ReadonlySignal<{ state: ArrayLike<number> & Iterable<number> } | null>,
): ReadonlySignal<Set<number>> {
  const present = computed(() => [...new Set(field.value?.state)].sort().join());
  return computed(() => new Set(present.value.split(",").filter(Boolean).map(Number)));
}

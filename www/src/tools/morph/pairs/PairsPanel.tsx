import "#ui/panel/fold.css";
import { halfTurns, pairing } from "#document/morph";
import { edit } from "#document/scene";
import { HalfTurns } from "#ui/panel/HalfTurns";
import { pairsOpen } from "../dialogs";
import { correspondence } from "../document-signals";
import { flatPairs, turnedFurther } from "../edits";
import { Pairs, PairWords } from "../later";
import * as messages from "./messages";
import css from "./pairs.module.css";

/** What had to be done so that each map has one to become, and what that costs; most pairs have nothing of it. */
export function PairNotes() {
  const { from, to, steps } = pairing.value;
  const flat = flatPairs(from, to, correspondence.value);
  return steps.length + flat.length > 0 ? <PairWords steps={steps} flat={flat} /> : null;
}

/** Which map becomes which: as it is, by hand, and what else there is. */
export function PairsPanel() {
  return (
    <>
      {halfTurns.value.some((turn) => turn !== 0) && (
        <div class={`notes ${css["pair-notes"]}`}>
          <HalfTurns other={halfTurns.value} onTurn={(by) => edit((before) => turnedFurther(before, by))} />
        </div>
      )}
      <details
        class={`fold ${css["pairs"]}`}
        open={pairsOpen.value}
        onToggle={(event) => {
          pairsOpen.value = event.currentTarget.open;
        }}
      >
        <summary>{messages.mapBecomes}</summary>
        {pairsOpen.value && <Pairs />}
      </details>
    </>
  );
}

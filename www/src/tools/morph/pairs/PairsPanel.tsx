import "#ui/panel/fold.css";
import { pairing } from "#document/morph";
import { listWords } from "#format/path-words";
import { Button } from "#ui/controls/Button";
import { flatPairs } from "../changes";
import { openRoutes, pairsOpen } from "../dialogs";
import { Pairs } from "../later";
import { correspondence } from "../parts";
import css from "./pairs.module.css";

/** What had to be done so that each map has one to become, and what that costs. */
export function PairNotes() {
  const { from, to, steps } = pairing.value;
  const flat = flatPairs(from, to, correspondence.value);
  if (steps.length === 0 && flat.length === 0) return null;
  return (
    <div class={`notes ${css["pair-notes"]}`}>
      {steps.map((step) => (
        <p key={step}>{step}</p>
      ))}
      {flat.length > 0 && (
        <>
          <p>
            {flat.length === 1 ? "Map" : "Maps"} {listWords(flat.map(String))}{" "}
            {flat.length === 1 ? "turns over on the way, so it" : "turn over on the way, so each"} must pass
            through a flat state.
          </p>
          <Button kind="quiet" onClick={openRoutes}>
            Other ways across
          </Button>
        </>
      )}
    </div>
  );
}

/** Which map becomes which: as it is, by hand, and what else there is. */
export function PairsPanel() {
  return (
    <details
      class={`fold ${css["pairs"]}`}
      open={pairsOpen.value}
      onToggle={(event) => {
        pairsOpen.value = event.currentTarget.open;
      }}
    >
      <summary>Which map becomes which</summary>
      {pairsOpen.value && <Pairs />}
    </details>
  );
}

import { listWords } from "#format/path-words";
import { Button } from "#ui/controls/Button";
import { openRoutes } from "../dialogs";
import css from "./pairs.module.css";

interface PairWordsProps {
  /** What had to be done, in sentences. */
  steps: readonly string[];
  /** The numbers of the maps that turn over. */
  flat: readonly number[];
}

/** What is said of a pair whose maps do not simply become each other. */
export function PairWords({ steps, flat }: PairWordsProps) {
  return (
    <div class={`notes ${css["pair-notes"]}`}>
      {steps.map((step) => (
        <p key={step}>{step}</p>
      ))}
      {flat.length > 0 && (
        <>
          <p>
            {flat.length === 1 ? "Map" : "Maps"} {listWords(flat.map(String))}{" "}
            {flat.length === 1
              ? "is a mirror image at one end, so it"
              : "are mirror images at one end, so each"}{" "}
            turns over on the way, and is as flat as a line for a moment.
          </p>
          <Button kind="quiet" onClick={openRoutes}>
            Other ways across
          </Button>
        </>
      )}
    </div>
  );
}

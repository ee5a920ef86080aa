import { Button } from "#ui/controls/Button";
import { openRoutes } from "../dialogs";
import * as messages from "./messages";
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
          <p>{messages.mirroredMaps(flat)}</p>
          <Button kind="quiet" onClick={openRoutes}>
            {messages.otherPaths}
          </Button>
        </>
      )}
    </div>
  );
}

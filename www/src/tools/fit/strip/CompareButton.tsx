import { HoldButton } from "#ui/controls/HoldButton";
import * as messages from "../messages";
import { comparing } from "../stage/layers";

/** While it is held, the outline is seen without the fit. */
export function CompareButton() {
  return (
    <HoldButton held={comparing} title={messages.holdToSeeOutline} command="compare">
      {messages.holdToCompare}
    </HoldButton>
  );
}

import { HoldButton } from "#ui/controls/HoldButton";
import { comparing } from "../stage/layers";

/** While it is held, the outline is seen without the fit. */
export function CompareButton() {
  return (
    <HoldButton
      held={comparing}
      title="Hold to see the outline, or the picture, without the fit"
      command="compare"
    >
      Hold to compare
    </HoldButton>
  );
}

import { heldPlain } from "#document/deform/bend";
import { HoldButton } from "#ui/controls/HoldButton";

/** While it is held, the bend is the plain one: nothing is shuffled. */
export function PlainButton() {
  return (
    <HoldButton held={heldPlain} title="Hold to see the plain bend, in which only the whole answers">
      Hold for plain
    </HoldButton>
  );
}

import { heldPlain } from "#document/deform/bend";
import { HoldButton } from "#ui/controls/HoldButton";
import * as messages from "../messages";

/** While it is held, the bend is the plain one: nothing is shuffled. */
export function PlainButton() {
  return (
    <HoldButton held={heldPlain} title={messages.holdToSeePlain}>
      {messages.holdForPlain}
    </HoldButton>
  );
}

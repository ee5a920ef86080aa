import { IconButton } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import * as messages from "../../messages";
import { resetChosen } from "../edit";
import meshCss from "../mesh.module.css";
import { chosen } from "./chosen";
import { type Hand, hand } from "./hand";

const HANDS: readonly { value: Hand; label: string; description: string }[] = [
  { value: "move", label: messages.move, description: messages.dragBesideHandlesTo },
  { value: "pull", label: messages.pull, description: messages.dragAnywhereToPull },
  {
    value: "choose",
    label: messages.select,
    description: messages.dragFrameToSelect,
  },
];

/** What the hand does on the picture: fingers have no modifier keys. */
export function HandBar() {
  return (
    <div class={meshCss["mesh-bar"]}>
      {chosen.value.size > 0 && (
        <IconButton
          icon="reset"
          label={chosen.value.size === 1 ? messages.resetHandle : messages.resetSelectedHandles}
          onClick={resetChosen}
        />
      )}
      <Segmented
        label={messages.dragMode}
        options={HANDS}
        value={hand.value}
        onChange={(next) => {
          hand.value = next;
        }}
      />
    </div>
  );
}

import { IconButton } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { resetChosen } from "../edit";
import meshCss from "../mesh.module.css";
import { chosen } from "./chosen";
import { type Hand, hand } from "./hand";

const HANDS: readonly { value: Hand; label: string; description: string }[] = [
  { value: "move", label: "Move", description: "A drag beside the handles moves the picture" },
  { value: "pull", label: "Pull", description: "A drag anywhere pulls at the grid there; Alt does the same" },
  {
    value: "choose",
    label: "Select",
    description: "A drag draws a frame that chooses the handles in it; Shift does the same",
  },
];

/** What the hand does on the picture: fingers have no modifier keys. */
export function HandBar() {
  return (
    <div class={meshCss["mesh-bar"]}>
      {chosen.value.size > 0 && (
        <IconButton
          icon="reset"
          label={chosen.value.size === 1 ? "Put the handle back" : "Put the chosen handles back"}
          onClick={resetChosen}
        />
      )}
      <Segmented
        label="What a drag on the picture does"
        options={HANDS}
        value={hand.value}
        onChange={(next) => {
          hand.value = next;
        }}
      />
    </div>
  );
}

import { computed } from "@preact/signals";
import { hand, space, spaceView } from "#document/space/space";
import { media } from "#style/media";
import { Button, IconButton } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { atOrigin, goToOrigin, showWhole } from "./actions";
import css from "./stage.module.css";

const HANDS = [
  { value: "look", label: "Look", description: "Drag to look around; the shapes stay" },
  { value: "turn", label: "Turn", description: "Drag to turn the object, by its parameters" },
  { value: "move", label: "Move", description: "Drag to move the object, by its parameters" },
  {
    value: "scale",
    label: "Scale",
    description: "Drag to make the object larger or smaller, by its parameters",
  },
] as const;

const small = media("(max-width: 37.4375em)");
const origin = computed(() => {
  const view = spaceView.value;
  return view?.holds === "eye" && atOrigin(view);
});
const objects = computed(() => space.value?.objects.length ?? 0);

/** What a drag does, and two places to look from. */
export function Toolbar() {
  return (
    <div class={css["space-bar"]}>
      <Segmented
        label={objects.value > 1 ? "What a drag does to the view or the chosen object" : "What a drag does"}
        options={HANDS}
        value={hand.value}
        command="hand"
        onChange={(next) => {
          hand.value = next;
        }}
      />
      <span class={css["space-bar-views"]}>
        {small.value ? (
          <Button
            pressed={origin.value}
            description="The eye at the origin, as the papers have it"
            command="origin"
            onClick={goToOrigin}
          >
            Origin
          </Button>
        ) : (
          <Button
            pressed={origin.value}
            description="As the papers have it: the eye stays at (0, 0, 0), and drags turn it there"
            command="origin"
            onClick={goToOrigin}
          >
            Eye at the origin
          </Button>
        )}
        <IconButton icon="whole" label="Whole view" command="fit" onClick={showWhole} />
      </span>
    </div>
  );
}

import { computed } from "@preact/signals";
import { hand, space, spaceView } from "#document/space/space";
import { media } from "#style/media";
import { Button, IconButton } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import * as messages from "../messages";
import { atOrigin, goToOrigin, showWhole } from "./actions";
import css from "./stage.module.css";

const HANDS = [
  { value: "look", label: messages.look, description: messages.dragToLookAround },
  { value: "turn", label: messages.rotate, description: messages.dragToRotateObject },
  { value: "move", label: messages.move, description: messages.dragToMoveObject },
  {
    value: "scale",
    label: messages.scale,
    description: messages.dragToScaleObject,
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
        label={objects.value > 1 ? messages.dragModeForView : messages.dragMode}
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
            description={messages.eyeAtOriginAs}
            command="origin"
            onClick={goToOrigin}
          >
            {messages.origin}
          </Button>
        ) : (
          <Button
            pressed={origin.value}
            description={messages.asInPapersEye}
            command="origin"
            onClick={goToOrigin}
          >
            {messages.eyeAtOrigin}
          </Button>
        )}
        <IconButton icon="whole" label={messages.showAll} command="fit" onClick={showWhole} />
      </span>
    </div>
  );
}

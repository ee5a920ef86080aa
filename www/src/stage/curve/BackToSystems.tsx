import { backToSystems } from "#document/curve/back";
import { announce } from "#document/notice";
import { scene } from "#document/scene";
import { Button } from "#ui/controls/Button";
import * as messages from "../messages";

/** Leaves what stands in place of the two systems. */
export function BackToSystems() {
  return (
    <Button
      kind="quiet"
      icon="back"
      onClick={() => {
        backToSystems();
        const { a, b } = scene.peek();
        announce(messages.backTo(a.name, b.name));
      }}
    >
      {messages.backToSystemsMaps}
    </Button>
  );
}

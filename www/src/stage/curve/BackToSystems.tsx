import { backToSystems } from "#document/curve/back";
import { announce } from "#document/notice";
import { scene } from "#document/scene";
import { Button } from "#ui/controls/Button";

/** Leaves what stands in place of the two systems. */
export function BackToSystems() {
  return (
    <Button
      kind="quiet"
      icon="back"
      onClick={() => {
        backToSystems();
        const { a, b } = scene.peek();
        announce(`Back to systems of maps: ${a.name} and ${b.name}.`);
      }}
    >
      Back to systems of maps
    </Button>
  );
}

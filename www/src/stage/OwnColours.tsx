import { computed } from "@preact/signals";
import { ownColours, withoutColours } from "#document/colours";
import { edit, scene } from "#document/scene";
import { Button } from "#ui/controls/Button";

const own = computed(() => ownColours(scene.value) !== null);

/** Where a file brought its colours: the way back to the page's. */
export function OwnColours() {
  if (!own.value) return null;
  return (
    <div class="row">
      <p class="hint">The colours are those of the file.</p>
      <Button kind="quiet" icon="reset" onClick={() => edit(withoutColours)}>
        Frond’s colours
      </Button>
    </div>
  );
}

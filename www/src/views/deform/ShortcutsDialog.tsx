import { help } from "../../state/help";
import { Dialog } from "../../ui/Dialog";
import { ShortcutTable } from "../../ui/ShortcutTable";
import { SHORTCUTS } from "./shortcuts";

/** The list of keys, opened by "?" or by its button. */
export function ShortcutsDialog() {
  if (!help.value) return null;
  return (
    <Dialog
      reading
      title="Keyboard"
      about="In number fields: ↑ and ↓ step, Shift finer, Alt coarser."
      onClose={() => {
        help.value = false;
      }}
    >
      <ShortcutTable groups={SHORTCUTS} />
    </Dialog>
  );
}

import { Dialog } from "./Dialog";
import { type ShortcutRow, ShortcutTable } from "./ShortcutTable";

export interface ShortcutsDialogProps {
  groups: readonly { title: string; rows: readonly ShortcutRow[] }[];
  onClose: () => void;
}

/** The list of a tool's keys, opened by "?" or by its button. */
export function ShortcutsDialog({ groups, onClose }: ShortcutsDialogProps) {
  return (
    <Dialog
      reading
      title="Keyboard"
      about="In number fields: ↑ and ↓ step, Shift finer, Alt coarser."
      onClose={onClose}
    >
      <ShortcutTable groups={groups} />
    </Dialog>
  );
}

import { help } from "#ui/help";
import { ShortcutsDialog as List } from "#ui/ShortcutsDialog";
import { SHORTCUTS } from "./shortcuts";

/** The keys of this tool, while they are asked for. */
export function ShortcutsDialog() {
  if (!help.value) return null;
  return (
    <List
      groups={SHORTCUTS}
      onClose={() => {
        help.value = false;
      }}
    />
  );
}

import type { ComponentChildren } from "preact";
import { help } from "../commands";
import { Button } from "../controls/Button";
import * as messages from "../messages";

/** The end of a tool's panel. */
export function PanelFoot({ children }: { children?: ComponentChildren }) {
  return (
    <footer class="panel-foot">
      {children}
      <Button
        kind="quiet"
        icon="keyboard"
        popup="dialog"
        onClick={() => {
          help.value = true;
        }}
      >
        {messages.keyboardShortcuts}
      </Button>
    </footer>
  );
}

import type { ComponentChildren } from "preact";
import { help } from "../commands";
import { Button } from "../controls/Button";

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
        Keyboard shortcuts
      </Button>
    </footer>
  );
}

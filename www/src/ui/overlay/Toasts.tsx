import "./overlay.css";
import { Button, IconButton } from "../controls/Button";
import * as messages from "../messages";

interface Action {
  label: string;
  run: () => void;
}

interface Toast {
  id: number;
  kind: "info" | "error";
  text: string;
  action?: Action;
  /** Another one, shown before it. */
  instead?: Action;
}

interface ToastsProps {
  toasts: readonly Toast[];
  onDismiss: (id: number) => void;
}

/** Short notices in a corner. Errors are read out at once, the others when there is a pause. */
export function Toasts({ toasts, onDismiss }: ToastsProps) {
  return (
    <section class="toasts" aria-label={messages.notices}>
      {toasts.map((toast) => (
        <div key={toast.id} class={`toast ${toast.kind}`} role={toast.kind === "error" ? "alert" : "status"}>
          <p>{toast.text}</p>
          {[toast.instead, toast.action].map(
            (action) =>
              action && (
                <Button
                  key={action.label}
                  kind="quiet"
                  onClick={() => {
                    action.run();
                    onDismiss(toast.id);
                  }}
                >
                  {action.label}
                </Button>
              ),
          )}
          <IconButton
            icon="close"
            label={messages.dismiss}
            kind="quiet"
            onClick={() => onDismiss(toast.id)}
          />
        </div>
      ))}
    </section>
  );
}

import "./hold-button.css";
import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";

export interface HoldButtonProps {
  held: boolean;
  onHold: (held: boolean) => void;
  /** What it does, and its key. */
  title: string;
  children: ComponentChildren;
}

/** Something else is seen while it is held, by a pointer or by a key. */
export function HoldButton({ held, onHold, title, children }: HoldButtonProps) {
  // biome-ignore lint/correctness/useExhaustiveDependencies: what is held is let go when the button goes
  useEffect(() => () => onHold(false), []);
  const letGo = () => onHold(false);
  return (
    <button
      type="button"
      class="button hold-button"
      aria-pressed={held}
      title={title}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        onHold(true);
      }}
      onPointerUp={letGo}
      onPointerCancel={letGo}
      onLostPointerCapture={letGo}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (event.key !== " " && event.key !== "Enter") return;
        event.preventDefault();
        onHold(true);
      }}
      onKeyUp={(event) => {
        if (event.key === " " || event.key === "Enter") onHold(false);
      }}
      onBlur={letGo}
    >
      {children}
    </button>
  );
}

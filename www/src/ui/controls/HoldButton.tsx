import "./hold-button.css";
import type { Signal } from "@preact/signals";
import type { ComponentChildren } from "preact";
import { useEffect } from "preact/hooks";
import { withKey } from "../commands";

interface HoldButtonProps {
  /** Whether it is. */
  held: Signal<boolean>;
  /** What it does. */
  title: string;
  /** The command that it stands for, whose key is told with the title. */
  command?: string;
  children: ComponentChildren;
}

/** Something else is seen while it is held, by a pointer or by a key. */
export function HoldButton({ held, title, command, children }: HoldButtonProps) {
  const hold = (on: boolean) => {
    held.value = on;
  };
  const letGo = () => hold(false);
  // biome-ignore lint/correctness/useExhaustiveDependencies: what is held is let go when the button goes
  useEffect(() => letGo, []);
  return (
    <button
      type="button"
      class="button hold-button"
      aria-pressed={held.value}
      title={withKey(title, command)}
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        hold(true);
      }}
      onPointerUp={letGo}
      onPointerCancel={letGo}
      onLostPointerCapture={letGo}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (event.key !== " " && event.key !== "Enter") return;
        event.preventDefault();
        hold(true);
      }}
      onKeyUp={(event) => {
        if (event.key === " " || event.key === "Enter") hold(false);
      }}
      onBlur={letGo}
    >
      {children}
    </button>
  );
}

import "./fold.css";
import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";

interface FoldProps {
  title: string;
  /** What it comes to, while it is closed. */
  now?: string | undefined;
  open?: boolean;
  children: ComponentChildren;
}

/** A part of the panel that opens. What is in it is there only while it is open. */
export function Fold({ title, now, open: first = false, children }: FoldProps) {
  const [open, setOpen] = useState(first);
  return (
    <details class="fold" open={open} onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>
        <span>{title}</span>
        {now !== undefined && <span class="fold-now">{now}</span>}
      </summary>
      {open && <div class="fold-body">{children}</div>}
    </details>
  );
}

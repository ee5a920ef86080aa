import { useEffect, useRef, useState } from "preact/hooks";
import "./overlay.css";
import { Button, IconButton } from "../controls/Button";
import type { IconName } from "../controls/Icon";
import css from "./overlay.module.css";

export interface MenuItem {
  label: string;
  icon?: IconName;
  disabled?: boolean;
  onSelect: () => void;
}

interface MenuProps {
  label: string;
  items: readonly MenuItem[];
  icon?: IconName;
}

/**
 * A button that opens a short list of things to do. Arrows, Home and End walk it; Escape and a press outside close it.
 */
export function Menu({ label, items, icon = "more" }: MenuProps) {
  const [open, setOpen] = useState(false);
  const root = useRef<HTMLDivElement>(null);
  const opener = useRef<HTMLButtonElement>(null);
  const list = useRef<HTMLDivElement>(null);

  useEffect(() => {
    if (!open) return;
    list.current?.querySelector<HTMLElement>("button:not(:disabled)")?.focus();
    const outside = (event: PointerEvent) => {
      if (event.target instanceof Node && root.current?.contains(event.target) !== true) setOpen(false);
    };
    document.addEventListener("pointerdown", outside, true);
    return () => document.removeEventListener("pointerdown", outside, true);
  }, [open]);

  const close = () => {
    setOpen(false);
    opener.current?.focus();
  };
  const walk = (event: KeyboardEvent) => {
    const all = [...(list.current?.querySelectorAll<HTMLElement>("button:not(:disabled)") ?? [])];
    const here = all.indexOf(document.activeElement as HTMLElement);
    const to = { ArrowDown: here + 1, ArrowUp: here - 1 + all.length, Home: 0, End: all.length - 1 }[
      event.key
    ];
    if (to !== undefined) {
      event.preventDefault();
      event.stopPropagation();
      all[to % all.length]?.focus();
    } else if (event.key === "Escape" || event.key === "Tab") {
      event.stopPropagation();
      close();
    }
  };

  return (
    <div class={css["menu"]} ref={root}>
      <IconButton
        buttonRef={opener}
        icon={icon}
        label={label}
        kind="quiet"
        popup="menu"
        expanded={open}
        onClick={() => setOpen(!open)}
      />
      {open && (
        <div class="menu-list" role="menu" aria-label={label} tabIndex={-1} ref={list} onKeyDown={walk}>
          {items.map((item) => (
            <MenuEntry key={item.label} item={item} close={close} />
          ))}
        </div>
      )}
    </div>
  );
}

function MenuEntry({ item, close }: { item: MenuItem; close: () => void }) {
  return (
    <Button
      kind="quiet"
      role="menuitem"
      class={css["menu-item"]}
      disabled={item.disabled ?? false}
      {...(item.icon === undefined ? {} : { icon: item.icon })}
      onClick={() => {
        close();
        item.onSelect();
      }}
    >
      {item.label}
    </Button>
  );
}

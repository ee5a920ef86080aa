import type { ComponentChildren } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { orbitKey } from "#ui/orbit/keys";
import layout from "../../kit/frame/layout.module.css";
import { MAPS } from "./cells";

interface KeyedProps {
  onMap: (letter: number) => void;
  onBack: () => void;
  /** Its keys are heard as well while nothing else on the page has the focus. One board of a page has that. */
  first?: boolean;
  children: ComponentChildren;
}

/** A board and its buttons. While the focus is in there, their keys do what they do. */
export function Keyed({ onMap, onBack, first = false, children }: KeyedProps) {
  const board = useRef<HTMLDivElement>(null);
  const onKey = (event: KeyboardEvent) => {
    const key = orbitKey(event, MAPS.length);
    if (key === null) return;
    event.preventDefault();
    if (key === "back") onBack();
    else onMap(key);
  };
  const latest = useRef(onKey);
  latest.current = onKey;
  useEffect(() => {
    if (!first) return;
    const onPage = (event: KeyboardEvent) => {
      if (event.defaultPrevented || document.querySelector("dialog[open]")) return;
      const here = board.current;
      // On slides it may not be shown.
      if (!here || here.getClientRects().length === 0 || !(event.target instanceof Element)) return;
      // What holds the board is the page, or its slide.
      const isRest = event.target !== here && event.target.contains(here);
      if (isRest || event.target.matches("h1, h2, h3")) latest.current(event);
    };
    document.addEventListener("keydown", onPage);
    return () => document.removeEventListener("keydown", onPage);
  }, [first]);
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the keys are those of the buttons within
    <div class={`${layout["two-columns"]} ${layout["even"]}`} ref={board} onKeyDown={onKey}>
      {children}
    </div>
  );
}

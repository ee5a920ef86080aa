import type { RefObject } from "preact";
import { useLayoutEffect, useRef } from "preact/hooks";

/**
 * For controls of which some rest while nothing is thrown. Whoever presses "Clear" would lose the focus with it, and
 * the keys: the first button of the controls, a number, takes it.
 */
export function useFocusKept(empty: boolean): RefObject<HTMLDivElement | null> {
  const controls = useRef<HTMLDivElement>(null);
  useLayoutEffect(() => {
    const { activeElement } = document;
    if (empty && controls.current?.contains(activeElement) && activeElement?.matches(":disabled"))
      controls.current.querySelector("button")?.focus();
  }, [empty]);
  return controls;
}

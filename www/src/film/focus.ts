/** Where the focus is in the dialog of films, whose contents take each other's place. */
import type { RefObject } from "preact";
import { useLayoutEffect } from "preact/hooks";
import { filmTold } from "./open";

/** Nothing has it: what had it is gone. */
const focusIsLost = (): boolean =>
  document.activeElement === null || document.activeElement === document.body;

/**
 * Where what had the focus has gone, the button takes it as soon as it is there, or, as long as it cannot be pressed,
 * the heading of its dialog. Whatever else has the focus keeps it.
 */
export function useFocusIfLost(button: RefObject<HTMLElement | null>): void {
  useLayoutEffect(() => {
    if (!focusIsLost()) return;
    button.current?.focus({ preventScroll: true });
    headingIfLost();
  }, [button]);
}

let fromChip = false;

/** The dialog is opened from the chip, which goes away as long as it is open: whoever closes it comes back to it. */
export function leaveChip(): void {
  fromChip = true;
}

/** Whether the chip, which is there again, takes the focus. */
export function isBackAtChip(): boolean {
  const back = fromChip && focusIsLost();
  fromChip = false;
  return back;
}

/** Where the focus goes from a dialog whose opener is gone; null where the chip takes it, or nothing had it before. */
export function besideChip(): HTMLElement | null {
  if (!fromChip || filmTold.peek()) return null;
  fromChip = false;
  return besideIt();
}

/** What is in the header where the chip was. */
export function besideIt(): HTMLElement | null {
  const menus = document.querySelectorAll<HTMLElement>(".tools [aria-haspopup='menu']");
  return [...menus].find((menu) => menu.getClientRects().length > 0) ?? null;
}

/** Where nothing has the focus, the heading of the dialog that is open takes it. */
export function headingIfLost(): void {
  if (!focusIsLost()) return;
  document.querySelector<HTMLElement>("dialog[open] h2")?.focus({ preventScroll: true });
}

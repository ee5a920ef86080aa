/** The steps of a page, `data-step` in it: what a link can lead to, and what a slide shows. */
import { type Field, text } from "./fields";
import type { PageState } from "./page-state";

/** Where the link of a page says which step it leads to. */
const AT = "at";
const NAME: Field<string> = text(/[a-z]{1,16}(?:-\d{1,2})?/);

/** The step that the address asks for. */
export function openedStep(page: PageState): string | null {
  return page.opened(AT, NAME);
}

export function stepsIn(inside: Element): HTMLElement[] {
  return [...inside.querySelectorAll<HTMLElement>("[data-step]")];
}

/** Brings a step into view and gives it the focus, so that reading goes on from there. */
export function showStep(inside: Element | null, name: string): void {
  const step = inside && stepsIn(inside).find(({ dataset }) => dataset["step"] === name);
  if (!step) return;
  step.tabIndex = -1;
  step.focus({ preventScroll: true });
  toTop(step);
}

/** Scrolls what scrolls, and not the page around it. */
export function toTop(step: Element): void {
  const main = step.closest("main");
  main?.scrollBy({ top: step.getBoundingClientRect().top - main.getBoundingClientRect().top });
}

/** A step as the state of an address has it. */
export function stepIn(name: string): [name: string, value: string] {
  return [AT, name];
}

/** What a picture of space is seen before. Pure. */

import { NIGHT, PAPER } from "#style/colours";
import { channelsOf, hexOf } from "#style/hex";

/** That of whatever page shows it. */
export const PAGE = "page";

export type Choice = "paper" | "night" | "own" | "page";

/** The colour itself, "#rrggbb"; documents from before there was a choice have that of the page. */
export function groundOf(background: string | undefined, page: string): string {
  return background === undefined || background === PAGE ? page : background;
}

export function choiceOf(background: string | undefined): Choice {
  if (background === undefined || background === PAGE) return "page";
  if (background === PAPER) return "paper";
  return background === NIGHT ? "night" : "own";
}

/** What is written into the document for a choice; a colour of one's own begins with what there is. */
export function chosenBackground(choice: Choice, ground: string): string {
  if (choice === "page") return PAGE;
  if (choice === "own") return ownFrom(ground);
  return choice === "paper" ? PAPER : NIGHT;
}

/** The same colour, to be changed: by one step where it would be taken for one of the two that have names. */
function ownFrom(ground: string): string {
  if (ground !== PAPER && ground !== NIGHT) return ground;
  const [red = 0, ...others] = channelsOf(ground);
  return hexOf([red + (ground === PAPER ? -1 : 1), ...others]);
}

/** Whether light colours stand out from it. */
export function isDark(colour: string): boolean {
  const part = (at: number) => (Number.parseInt(colour.slice(at, at + 2), 16) / 255) ** 2.2;
  return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5) < 0.18;
}

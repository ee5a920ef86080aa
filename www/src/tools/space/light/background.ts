/** What a picture of space is seen before. Pure. */

import { NIGHT, PAPER } from "#style/colours";
import { ownFrom } from "#style/ground";

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

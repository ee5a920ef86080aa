/** What a picture of space is seen before. Pure. */

import { formatNumber } from "#format/numbers";
import { NIGHT, PAPER } from "#style/colours";
import { ownFrom } from "#style/ground";
import type { Point3 } from "#wasm/api";
import * as messages from "../messages";

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

// What the settings of light come to, in words. Pure.

const DEGREE = Math.PI / 180;

export const degrees = (radians: number): number => radians / DEGREE;
export const radians = (degrees: number): number => degrees * DEGREE;

/** Where the light comes from, as the eye has it. */
export function sideWords(side: number): string {
  const d = Math.round(degrees(side));
  if (Math.abs(d) < 5) return messages.fromAbove;
  if (Math.abs(d) > 175) return messages.fromBelow;
  const way = d > 0 ? "right" : "left";
  const at = Math.abs(d);
  if (at < 60) return messages.fromAboveOf(at, way);
  if (at <= 120) return messages.fromSide(way);
  return messages.fromBelowOf(180 - at, way);
}

/** How far the light stands on the eye's side. */
export function frontWords(front: number): string {
  if (front < 0.15) return "grazing";
  if (front > 0.85) return messages.fromViewer;
  return messages.frontPercent(Math.round(100 * front));
}

export function shareWords(share: number, none: string): string {
  return share === 0 ? none : `${Math.round(100 * share)} %`;
}

export function pointWords(point: Point3): string {
  // What is nearly zero is zero: nobody reads 1e-17.
  const size = Math.max(1, ...point.map(Math.abs));
  return `(${point.map((x) => formatNumber(Math.abs(x) < 1e-6 * size ? 0 : x, 3)).join(", ")})`;
}

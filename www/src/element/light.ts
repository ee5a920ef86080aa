/** What attributes say of how it looks and plays, for which nothing has to be opened anew. */
import { momentOf, type Read, WishError } from "./wish";

/** Seconds from one end to the other. */
export const SECONDS = { usual: 8, least: 0.5, most: 600 };

/** The attributes that are read here, and which of them say something that means nothing. */
export const JUDGED = ["t", "seconds", "theme"] as const;

export function lightTroubles(attribute: Read): WishError[] {
  const troubles: WishError[] = [];
  try {
    momentOf(attribute("t"));
  } catch (problem) {
    troubles.push(problem as WishError);
  }
  const seconds = attribute("seconds");
  if (seconds !== null && !Number.isFinite(Number(seconds)))
    troubles.push(
      new WishError("seconds", `seconds is a number from ${SECONDS.least} to ${SECONDS.most}, such as 8.`),
    );
  const theme = attribute("theme")?.trim() ?? "";
  if (!["", "auto", "light", "dark"].includes(theme))
    troubles.push(new WishError("theme", "theme is light, dark or auto."));
  return troubles;
}

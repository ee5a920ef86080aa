import * as messages from "./messages";

const DAY = new Intl.DateTimeFormat("en", { dateStyle: "medium", timeStyle: "short" });

/** When something was kept, in words; `time` in milliseconds since 1970. Dates of other programs may be none. */
export function whenWords(time: number): string {
  try {
    return DAY.format(time);
  } catch {
    return messages.someTimeAgo;
  }
}

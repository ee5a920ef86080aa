/** What this browser remembers of a visit: whether there was one, and how far the round went. */

const KEY = "frond.guide";

/** Null on a first visit; the step at which the round was left; "seen" where there is nothing to go on with. */
export type Seen = null | number | "seen";

/** What was kept is not trusted. */
export function seenIn(text: string | null, steps: number): Seen {
  if (text === null) return null;
  const step = /^\d{1,2}$/.test(text) ? Number(text) : steps;
  return step < steps ? step : "seen";
}

/** Storage that is forbidden counts as seen: nobody is greeted at every visit. */
export function seen(steps: number): Seen {
  try {
    return seenIn(localStorage.getItem(KEY), steps);
  } catch {
    return "seen";
  }
}

export function keepSeen(what: number | "seen"): void {
  try {
    localStorage.setItem(KEY, String(what));
  } catch {
    // For this visit it is known without.
  }
}

const ROUND = "frond.round";

/** The step at which this tab is in the midst of the round, so that it goes on there after a reload; null for none. */
export function underWay(steps: number): number | null {
  try {
    const step = seenIn(sessionStorage.getItem(ROUND), steps);
    return typeof step === "number" ? step : null;
  } catch {
    return null;
  }
}

export function keepUnderWay(step: number | null): void {
  try {
    if (step === null) sessionStorage.removeItem(ROUND);
    else sessionStorage.setItem(ROUND, String(step));
  } catch {
    // Then it begins where it was left.
  }
}

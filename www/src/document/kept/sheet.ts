/** The class sheet that this tab came from, so that there is a way back to it from wherever it led. */
const KEY = "frond.sheet";

/** Notes the sheet by what its address has after the place; null where there is none to go back to. */
export function cameFrom(state: string | null): void {
  try {
    if (state === null) sessionStorage.removeItem(KEY);
    else sessionStorage.setItem(KEY, state);
  } catch {
    // Then the browser's own way back has to do.
  }
}

/** Whether that sheet hides for now what is right: so do the lessons that it led to, by whatever way. */
export const sheetHides = (): boolean => /[/&]hide=1(?=&|$)/.test(sheetBehind() ?? "");

/** Where the sheet is; null where this tab has seen none. */
export function sheetBehind(): string | null {
  try {
    const state = sessionStorage.getItem(KEY);
    return state && `#learn/sheet/${state}`;
  } catch {
    return null;
  }
}

/** What a pupil has written on sheets; kept in this browser alone, the latest sheets only. */

/** What is kept of a sheet. */
export interface Kept {
  /** Its address. */
  sheet: string;
  name: string;
  /** By the names of its items. */
  answers: Readonly<Record<string, string>>;
  /** Shapes and links that were ticked. */
  seen: readonly string[];
}

function isKept(value: unknown): value is Kept {
  if (typeof value !== "object" || value === null) return false;
  const { sheet, name, answers, seen } = value as Record<string, unknown>;
  return (
    typeof sheet === "string" &&
    typeof name === "string" &&
    typeof answers === "object" &&
    answers !== null &&
    Object.values(answers).every((answer) => typeof answer === "string") &&
    Array.isArray(seen) &&
    seen.every((item) => typeof item === "string")
  );
}

const KEY = "frond.sheets";
const MOST_SHEETS = 20;

function all(): Kept[] {
  try {
    const value: unknown = JSON.parse(localStorage.getItem(KEY) ?? "[]");
    return Array.isArray(value) ? value.filter(isKept) : [];
  } catch {
    return [];
  }
}

/** What is kept of a sheet, by its address. */
export function keptOf(sheet: string): Kept {
  return all().find((one) => one.sheet === sheet) ?? { sheet, name: "", answers: {}, seen: [] };
}

/** Keeps it; false where the browser does not. */
export function keep(kept: Kept): boolean {
  try {
    const others = all().filter(({ sheet }) => sheet !== kept.sheet);
    localStorage.setItem(KEY, JSON.stringify([kept, ...others].slice(0, MOST_SHEETS)));
    return true;
  } catch {
    return false;
  }
}

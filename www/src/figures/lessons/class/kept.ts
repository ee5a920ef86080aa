/** What pupils have written on sheets, and the sheet in the making; kept in this browser alone, the latest only. */
import { type Sheet, sheetKept, sheetOfKept, withoutHiding } from "./sheet";

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

const DRAFT = "frond.sheet-made";

/** The sheet that a teacher was making in this browser. */
export function draft(): Sheet {
  try {
    return sheetOfKept(localStorage.getItem(DRAFT));
  } catch {
    return sheetOfKept(null);
  }
}

export function keepDraft(sheet: Sheet): void {
  try {
    localStorage.setItem(DRAFT, sheetKept(sheet));
  } catch {
    // It lasts as long as the page.
  }
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

/** What is kept of a sheet, by its address; it is the same whether answers are hidden or not. */
export function keptOf(state: string): Kept {
  const sheet = withoutHiding(state);
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

const SIZE = "frond.class-size";

/** How many pupils there are in the class; null where nobody said. */
export function classSize(): number | null {
  try {
    const size = Number(localStorage.getItem(SIZE));
    return Number.isInteger(size) && size > 0 && size < 1000 ? size : null;
  } catch {
    return null;
  }
}

export function keepClassSize(size: number | null): void {
  try {
    if (size === null) localStorage.removeItem(SIZE);
    else localStorage.setItem(SIZE, String(size));
  } catch {
    // It lasts as long as the page.
  }
}

/** What the page has to say, on screen and to screen readers. */
import { type ReadonlySignal, signal } from "@preact/signals";
import * as messages from "./messages";

interface Action {
  label: string;
  run: () => void;
}

interface Notice {
  id: number;
  kind: "info" | "error";
  text: string;
  action?: Action;
  /** Another one, shown before it. */
  instead?: Action;
  /** It tells of work that goes on, and stays until the work has ended: `dismiss` it then. */
  stays?: boolean;
}

const shown = signal<Notice[]>([]);
const spoken = signal("");
let next = 1;

/** What the page has to say, oldest first. Infos leave by themselves unless they stay, errors stay until dismissed. */
export const notices: ReadonlySignal<Notice[]> = shown;

/** The text of the polite live region. */
export const announcement: ReadonlySignal<string> = spoken;

const INFO_MS = 5000;
const MOST_NOTICES = 4;

export function notify(notice: Omit<Notice, "id">): number {
  const same = shown.peek().find((n) => n.text === notice.text && n.kind === notice.kind);
  if (same) return same.id;
  const id = next++;
  shown.value = [...shown.peek(), { ...notice, id }].slice(-MOST_NOTICES);
  if (notice.kind === "info" && !notice.stays)
    setTimeout(() => dismiss(id), notice.action ? 2 * INFO_MS : INFO_MS);
  return id;
}

export function dismiss(id: number): void {
  shown.value = shown.peek().filter((n) => n.id !== id);
}

/** Says something to screen readers without showing it. */
export function announce(text: string): void {
  spoken.value = text;
}

/**
 * What browsers, Vite and the loader of modules say of a part of the page that is not there, or where a host sends a
 * page in its place: a newer version of the site may have other files.
 */
const UNFETCHED =
  /dynamically imported module|importing a module script failed|unable to preload css|program could not be loaded|failed to fetch|load failed|networkerror when attempting|expected magic word|match magic number|module doesn't start with/i;

/** For what only another start of the page may mend. */
export const loadAgain = { label: messages.reload, run: () => location.reload() };

/** Whether a part of the page is missing: another start of it helps. */
export const isUnfetched = (problem: unknown): boolean => wordsOf(problem) === messages.partNotFetched;

/** The words of anything that was thrown: a `FrondError`, an `Error`, or a bare value. */
export function wordsOf(problem: unknown): string {
  if (typeof problem === "object" && problem !== null && "message" in problem) {
    const { message } = problem as { message: unknown };
    if (typeof message === "string" && UNFETCHED.test(message)) return messages.partNotFetched;
    if (typeof message === "string" && message) return message;
  }
  return String(problem);
}

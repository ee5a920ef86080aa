/** What the page has to say, on screen and to screen readers. */
import { type ReadonlySignal, signal } from "@preact/signals";

interface Notice {
  id: number;
  kind: "info" | "error";
  text: string;
  action?: { label: string; run: () => void };
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

/** The words of anything that was thrown: a `FrondError`, an `Error`, or a bare value. */
export function wordsOf(problem: unknown): string {
  if (typeof problem === "object" && problem !== null && "message" in problem) {
    const { message } = problem as { message: unknown };
    if (typeof message === "string" && message) return message;
  }
  return String(problem);
}

/** Which lessons somebody has done, and which exercises; kept in this browser and told to nobody. */
import { type ReadonlySignal, signal } from "@preact/signals";

const KEY = "frond.done";
/** More than the course will ever have: what is read is not trusted. */
const MOST = 1000;

/** Storage may be missing, full or forbidden: then the marks last as long as the page. */
function read(): ReadonlySet<string> {
  try {
    return marksIn(localStorage.getItem(KEY));
  } catch {
    return new Set();
  }
}

/** The marks in what was kept; none where it cannot be read. */
export function marksIn(text: string | null): ReadonlySet<string> {
  const names = (text ?? "").split(" ").filter((name) => /^e\d{1,4}(?:\.\d{1,2})?$/.test(name));
  return new Set(names.slice(0, MOST));
}

const marks = signal<ReadonlySet<string>>(read());

/** The addresses of the lessons that are done (`e1`) and of their exercises (`e1.2` is the second). */
export const done: ReadonlySignal<ReadonlySet<string>> = marks;

export function markDone(name: string, is = true): void {
  const before = marks.peek();
  if (before.has(name) === is) return;
  const next = new Set(before);
  if (is) next.add(name);
  else next.delete(name);
  keep(next);
}

/** As if nobody had been here. */
export function clearDone(): void {
  keep(new Set());
}

function keep(next: ReadonlySet<string>): void {
  marks.value = next;
  try {
    if (next.size === 0) localStorage.removeItem(KEY);
    else localStorage.setItem(KEY, [...next].join(" "));
  } catch {
    // Kept for this visit only.
  }
}

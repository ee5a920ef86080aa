/** Which handles are chosen, and which one of them the keys act on. */
import { batch, computed, type ReadonlySignal, signal } from "@preact/signals";
import { mesh } from "../document";

const picked = signal<ReadonlySet<number>>(new Set());
const last = signal(0);

const count = computed(() => mesh.value.columns * mesh.value.rows);

/** Those that a drag of one of them moves. */
export const chosen: ReadonlySignal<ReadonlySet<number>> = computed(() => {
  const all = picked.value;
  // A smaller mesh has lost some of them.
  const kept = [...all].filter((index) => index < count.value);
  return kept.length === all.size ? all : new Set(kept);
});

/** The one that has, or would get, the focus. */
export const lead: ReadonlySignal<number> = computed(() => Math.min(last.value, count.value - 1));

/** Chooses these and no others. */
export function choose(handles: Iterable<number>, leading?: number): void {
  batch(() => {
    picked.value = new Set(handles);
    if (leading !== undefined) last.value = leading;
  });
}

/** Chooses one more, or one less. */
export function toggle(index: number): void {
  const next = new Set(chosen.peek());
  if (!next.delete(index)) next.add(index);
  choose(next, index);
}

export function clearChosen(): void {
  if (picked.peek().size > 0) picked.value = new Set();
}

/** The focus goes to a handle: while no more than one is chosen, the choice goes with it. */
export function lookAt(index: number): void {
  if (chosen.peek().size > 1) last.value = index;
  else choose([index], index);
}

/** Undo and redo as values. */
import type { Scene } from "#wasm/api";

/** One undo step: the scene before and after it. */
interface Step {
  before: Scene;
  after: Scene;
  gesture: string | undefined;
}

/** The undo stack as a value: nothing in here is ever changed in place. */
export interface History {
  past: readonly Step[];
  future: readonly Step[];
  /** Whether the last step may still grow: its gesture has not ended. */
  open: boolean;
}

export const LONGEST = 200;
export const EMPTY: History = { past: [], future: [], open: false };

/** Notes a change. Consecutive changes with the same gesture id are one step until the gesture ends. */
export function record(history: History, before: Scene, after: Scene, gesture?: string): History {
  const last = history.past.at(-1);
  if (last && history.open && gesture !== undefined && last.gesture === gesture) {
    return { past: [...history.past.slice(0, -1), { ...last, after }], future: [], open: true };
  }
  const past = [...history.past, { before, after, gesture }].slice(-LONGEST);
  return { past, future: [], open: gesture !== undefined };
}

export function close(history: History): History {
  return history.open ? { ...history, open: false } : history;
}

/**
 * Some of a document belongs to whoever looks, as the moment and the view do: a step that did not change it leaves it
 * as it is now. `target` is where the step goes, `other` where it comes from.
 */
export type Keep = (target: Scene, other: Scene, present: Scene) => Scene;

export function stepBack(
  history: History,
  present: Scene,
  keep: Keep,
): { history: History; scene: Scene } | null {
  const step = history.past.at(-1);
  if (!step) return null;
  const scene = keep(step.before, step.after, present);
  return {
    history: { past: history.past.slice(0, -1), future: [step, ...history.future], open: false },
    scene,
  };
}

export function stepForward(
  history: History,
  present: Scene,
  keep: Keep,
): { history: History; scene: Scene } | null {
  const [step, ...future] = history.future;
  if (!step) return null;
  const scene = keep(step.after, step.before, present);
  return { history: { past: [...history.past, step], future, open: false }, scene };
}

import type { Scene, SpacePart } from "#wasm/api";

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
 * The moment, the view and the tool belong to whoever looks, so a step that did not change them leaves them where they
 * are now.
 */
function restore(target: Scene, other: Scene, present: Scene): Scene {
  const scene: Scene = { ...target, t: target.t === other.t ? present.t : target.t };
  const view = target.view === other.view ? present.view : target.view;
  if (view) scene.view = view;
  else delete scene.view;
  const tool = target.tool === other.tool ? present.tool : target.tool;
  if (tool) scene.tool = tool;
  else delete scene.tool;
  if (scene.deform && present.deform && scene.deform.phase === other.deform?.phase) {
    scene.deform = { ...scene.deform, phase: present.deform.phase };
  }
  if (present.space) scene.space = restoreSpace(target.space, other.space, present.space);
  return scene;
}

/** The same of space. */
function restoreSpace(
  target: SpacePart | undefined,
  other: SpacePart | undefined,
  present: SpacePart,
): SpacePart {
  const view = target?.view === other?.view ? present.view : target?.view;
  const at = (target?.at ?? 0) === (other?.at ?? 0) ? present.at : (target?.at ?? 0);
  const own = target?.own === other?.own ? present.own : target?.own;
  return { packed: target?.packed ?? "", at, ...(view ? { view } : {}), ...(view && own ? { own } : {}) };
}

export function stepBack(history: History, present: Scene): { history: History; scene: Scene } | null {
  const step = history.past.at(-1);
  if (!step) return null;
  const scene = restore(step.before, step.after, present);
  return {
    history: { past: history.past.slice(0, -1), future: [step, ...history.future], open: false },
    scene,
  };
}

export function stepForward(history: History, present: Scene): { history: History; scene: Scene } | null {
  const [step, ...future] = history.future;
  if (!step) return null;
  const scene = restore(step.after, step.before, present);
  return { history: { past: [...history.past, step], future, open: false }, scene };
}

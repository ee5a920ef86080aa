/** A shape from the gallery, a file or the plane becomes an object of space. */

import { announce, notify, wordsOf } from "#document/notice";
import { scene, undo } from "#document/scene";
import { changeSpace, type Look, reshapeSpace, startWith } from "#document/space/edits";
import { choose, chosen, setView, space, spaceFrame } from "#document/space/space";
import type { SpaceObject } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";
import { factsOf } from "../now";
import { around, beside, MOST_OBJECTS, withObject, withShape } from "../object-edits";

/** Alone, with neither morph nor time line; in place of the chosen object; or beside what there is. */
export type How = "alone" | "instead" | "beside";

/** What was done, where `name` was taken in and `chosen` was the chosen object. */
export function takenWords(name: string, how: How, chosen: string): string {
  if (how === "beside") return messages.isAdded(name);
  if (how === "instead") return messages.replaces(name, chosen);
  return messages.isAlone(name);
}

/** Says what was done; where something has left, with a way back. */
function tellOf(what: string, left: boolean, aloud: boolean): void {
  if (!left) {
    if (aloud) notify({ kind: "info", text: what });
    else announce(what);
    return;
  }
  const { space: after } = scene.peek();
  const back = () => {
    // What was done since is not to be undone for it.
    if (scene.peek().space?.packed === after?.packed) undo();
    else
      notify({
        kind: "info",
        text: messages.thereLaterChangesUndo,
      });
  };
  notify({ kind: "info", text: what, action: { label: messages.undo, run: back } });
}

/**
 * Takes objects in, and says `what` was done, to be seen where `aloud`; their `look` comes with them where they stand
 * alone. Of what cannot be taken it says why, and nothing changes.
 */
export function take(
  objects: readonly SpaceObject[],
  how: How,
  what: string,
  { aloud = false, look }: { aloud?: boolean; look?: Look | undefined } = {},
): void {
  const [first] = objects;
  if (!first) return;
  const before = space.peek();
  const much = (before?.objects.length ?? 0) > 1 || before?.morph || before?.timeline;
  try {
    for (const { maps } of objects) solid.validate3(maps);
    if (how === "alone") {
      startWith([...objects], look);
      choose(0);
    } else if (how === "instead") {
      const { moved: _moved, tint: _tint, ...shape } = first;
      if (!reshapeSpace((now) => withShape(now, chosen.peek(), shape))) return;
    } else {
      if ((space.peek()?.objects.length ?? 0) + objects.length > MOST_OBJECTS) {
        notify({ kind: "error", text: messages.mostObjects(MOST_OBJECTS) });
        return;
      }
      const placed = objects.length === 1 ? [besideAll(first)] : objects;
      if (!changeSpace((now) => placed.reduce(withObject, now))) return;
      choose((space.peek()?.objects.length ?? 1) - 1);
      // All of it is to be seen.
      setView(null);
    }
    tellOf(what, how !== "beside" && Boolean(much), aloud);
  } catch (problem) {
    notify({ kind: "error", text: messages.cannotUse(first.name, wordsOf(problem)) });
  }
}

/** To the side of everything, as large as what is chosen now. */
function besideAll(object: SpaceObject): SpaceObject {
  const now = spaceFrame.peek()?.objects.map((one) => factsOf(one.now)) ?? [];
  const balls = now.filter((one) => one !== null);
  const ball = factsOf(object.maps);
  if (!ball || balls.length === 0) return object;
  const radius = now[chosen.peek()]?.radius ?? ball.radius;
  return { ...object, moved: beside(ball, around(balls), radius) };
}

import type { Keep } from "#document/history";
import type { ToolEntry } from "#stage/tool";
import * as messages from "./messages";

/** The moment of space, and where it is seen from. */
const keepLook: Keep = (target, other, { space: present }) => {
  if (!present) return target;
  const [to, from] = [target.space, other.space];
  const view = to?.view === from?.view ? present.view : to?.view;
  const at = (to?.at ?? 0) === (from?.at ?? 0) ? present.at : (to?.at ?? 0);
  const own = to?.own === from?.own ? present.own : to?.own;
  const space = { packed: to?.packed ?? "", at, ...(view ? { view } : {}), ...(view && own ? { own } : {}) };
  return { ...target, space };
};

export const space: ToolEntry = {
  id: "space",
  label: messages.space,
  title: messages.frondRotateAndMove,
  side: messages.shapesMorphAndLight,
  stage: messages.space,
  tool: () => import("./tool").then((module) => module.openTool()),
  keepOnUndo: keepLook,
  missing: messages.spaceCouldNotLoaded,
};

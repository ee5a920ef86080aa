/** The tools of the studio, in the order of the bar on top. */
import { effect, signal } from "@preact/signals";
import { keepToo } from "#document/keep";
import { loadAgain, notify, wordsOf } from "#document/notice";
import { tool as opened, openTool } from "#document/tool";
import type { Tool, ToolEntry } from "#stage/tool";
import { deform } from "#tools/deform/entry";
import { fit } from "#tools/fit/entry";
import { morph } from "#tools/morph/tool";
import { space } from "#tools/space/entry";

export const TOOLS: readonly ToolEntry[] = [morph, deform, fit, space];

for (const { keepOnUndo } of TOOLS) if (keepOnUndo) keepToo(keepOnUndo);

const entryOf = (id: ToolEntry["id"]): ToolEntry => TOOLS.find((entry) => entry.id === id) ?? morph;

const fetched = signal<ReadonlyMap<ToolEntry, Tool>>(new Map());

/** The tool that is open; without its value until it is there. */
export function openedTool(): { entry: ToolEntry; tool: Tool | null } {
  const entry = entryOf(opened.value);
  const tool = typeof entry.tool === "function" ? (fetched.value.get(entry) ?? null) : entry.tool;
  return { entry, tool };
}

/** Opens a tool, and has it once it is there. */
export function whenOpen(id: ToolEntry["id"]): Promise<Tool> {
  openTool(id);
  return new Promise((resolve) => {
    const stop = effect(() => {
      const { entry, tool } = openedTool();
      // Whoever goes elsewhere meanwhile does not wait for it any more.
      if (entry.id !== id || !tool) return;
      queueMicrotask(() => stop());
      resolve(tool);
    });
  });
}

/** Fetches tools when they are first opened, until the returned function is called. */
export function watchTools(): () => void {
  return effect(() => {
    const entry = entryOf(opened.value);
    if (typeof entry.tool !== "function" || fetched.peek().has(entry)) return;
    entry.tool().then(
      (tool) => {
        fetched.value = new Map(fetched.peek()).set(entry, tool);
      },
      (problem) =>
        notify({ kind: "error", text: `${entry.missing}. ${wordsOf(problem)}`, action: loadAgain }),
    );
  });
}

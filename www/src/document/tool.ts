import { computed, type ReadonlySignal } from "@preact/signals";
import type { Tool } from "#wasm/api";
import { replace, scene } from "./scene";

/** The tool that is open. */
export const tool: ReadonlySignal<Tool> = computed(() => scene.value.tool ?? "morph");

/** Opens a tool: where one is is part of the document, but going there is nothing to undo. */
export function openTool(next: Tool): void {
  if (next !== tool.peek()) replace({ ...scene.peek(), tool: next });
}

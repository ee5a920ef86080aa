/** Maps as text for other programs: whether that is asked for, and of which. */
import { signal } from "@preact/signals";
import type { MapRow, MapRow3 } from "#wasm/api";
import type { Command } from "../commands";
import * as messages from "../messages";

/** Maps that can be written. */
export interface NamedMaps {
  /** In a word, among others: "A". */
  label: string;
  name: string;
  maps: readonly MapRow[] | readonly MapRow3[];
  /** How often the chaos game takes each, where that is said. */
  weights?: readonly number[] | undefined;
  /** "#rrggbb": their colours, repeated where there are more maps; those of the page are no part of a file. */
  palette?: readonly string[] | null;
}

/** Whether the dialog is open. */
export const exporting = signal(false);

export function startExport(): void {
  exporting.value = true;
}

/** In every tool that has maps. */
export function exportCommand(enabled: () => boolean = () => true): Command {
  return {
    id: "export",
    label: messages.mapsAsText,
    group: messages.everywhere,
    keys: ["T"],
    enabled,
    run: startExport,
  };
}

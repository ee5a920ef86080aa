/** What can be done with the document as a whole: its link, and files of it. */
import { computed } from "@preact/signals";
import { pictureShown } from "#document/deform/picture";
import { addressBar, Link } from "#document/link";
import { selection } from "#document/morph";
import { notify, wordsOf } from "#document/notice";
import { spacePlaying } from "#document/playback";
import { standIn } from "#document/stand-in";
import { adoptPath } from "#tools/morph/locus/path/automatic";
import type { Tool } from "#wasm/api";
import { frond } from "#wasm/core";
import * as messages from "./messages";
import { openedTool } from "./tools";

/** The one link between this page's document and its address. */
export const link = new Link(frond, addressBar, () => {
  selection.value = null;
  spacePlaying.value = false;
  adoptPath();
});

/** Where the studio is, with the document as it stands now and a tool, that which is open by default. */
export function studioHref(tool?: Tool): string {
  return `#${link.fragment(tool ? { tool } : {}) ?? ""}`;
}

/** The files that a closed curve can be saved as. */
export const CURVE_FILES = ["png", "svg", "csv", "json"] as const;

export async function saveCurve(kind: (typeof CURVE_FILES)[number]): Promise<void> {
  await fetched(
    () => import("#curve/save"),
    (module) => module.save(kind),
  );
}

/** What would be saved in place of a system. */
export const insteadOnStage = computed(() => (pictureShown.value ? null : standIn.value));

/** The picture as it stands on the stage, larger, complete, on a transparent ground. */
export async function savePicture(): Promise<void> {
  const { entry, tool } = openedTool();
  if (entry.stage !== undefined) await tool?.savePng?.();
  else await fetched(fetchSave, (module) => module.savePicture(link.fragment()));
}

/** On paper, with its maps and its link. */
export const printStage = (): Promise<void> =>
  fetched(
    () => import("./print/print"),
    (module) => module.print(),
  );

/** It is not part of the first script. */
const fetchSave = () => import("./save");

async function fetched<T>(module: () => Promise<T>, use: (module: T) => void | Promise<void>): Promise<void> {
  try {
    await use(await module());
  } catch (problem) {
    notify({ kind: "error", text: messages.savingFailed(wordsOf(problem)) });
  }
}

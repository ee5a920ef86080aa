/** Files of systems of space, as Fractint has them. */
import { signal } from "@preact/signals";
import { notify, wordsOf } from "#document/notice";
import { space } from "#document/space/space";
import { download, plainName } from "#ui/files/download";
import { solid } from "#wasm/space";
import { isAnimation, takeAnimation } from "../../time/saved/open";
import { object, parameters } from "../now";
import { take } from "./take";

/** One of the systems of a file. */
export type Found = ReturnType<typeof solid.parseIfs3>[number];

/** A file with several systems, of which one is to be chosen. */
export const opened = signal<{ file: string; systems: Found[]; flat: number } | null>(null);

/** Far more than any such file; so much is read at once. */
const MOST_BYTES = 1_000_000;

export async function openFile(file: File): Promise<void> {
  if (isAnimation(file)) return takeAnimation(file);
  try {
    if (file.size > MOST_BYTES) throw new Error("it is larger than a megabyte, and so no file of maps.");
    const text = await file.text();
    const systems = solid.parseIfs3(text);
    const flat = solid.countFlat(text);
    const [only] = systems;
    if (systems.length === 1 && only) takeFound(only, flat);
    else opened.value = { file: file.name, systems, flat };
  } catch (problem) {
    notify({ kind: "error", text: `${file.name} could not be read: ${wordsOf(problem)}` });
  }
}

/** What is said of the systems of a file that cannot be had here; nothing where there are none. */
export function leftOut(flat: number): string {
  if (flat === 0) return "";
  const what = flat === 1 ? "One system of the plane is" : `${flat} systems of the plane are`;
  return `${what} left out: no tool opens ${flat === 1 ? "it" : "them"} from a file yet.`;
}

/** Alone, or beside what there is where that is several: no object of several leaves unasked. */
export function takeFound({ name, maps }: Found, flat = 0): void {
  const several = (space.peek()?.objects.length ?? 1) > 1;
  const there = several
    ? `${name} stands beside what there is, with ${maps.length} maps.`
    : `${name} is there, with ${maps.length} maps, in place of what was. Undo brings that back.`;
  const what = `${there} ${leftOut(flat)}`.trim();
  take([{ name, maps }], several ? "beside" : "alone", what, true);
}

/** Saves the parameters as they are now: what was done to the object is in them. */
export function saveFile(): void {
  const name = object.peek()?.name ?? "Shape";
  try {
    const text = solid.writeIfs3(name, parameters.peek());
    download(new Blob([text], { type: "text/plain" }), `frond-${plainName(name, "shape", 32)}.ifs`);
  } catch (problem) {
    notify({ kind: "error", text: `${name} could not be saved: ${wordsOf(problem)}` });
  }
}

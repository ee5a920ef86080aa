/**
 * Whatever is dropped on the page, pasted or chosen comes in here: what it is is told by what is in it, and it opens in
 * the tool it belongs to, as one step to undo.
 */
import { signal } from "@preact/signals";
import { notify, wordsOf } from "#document/notice";
import { cameFrom, edit, lastStep } from "#document/scene";
import { tool } from "#document/tool";
import { arrived } from "#format/link-mending";
import { openFile, takeFiles } from "#ui/files/door";
import { focusOf } from "#ui/focus";
import type { ImportedFile, ImportedSystem, Tool } from "#wasm/api";
import { frond } from "#wasm/core";
import { loadExchange } from "#wasm/exchange";
import { whenOpen } from "../tools";
import { cameraWords, planeView, solidView } from "./camera";
import * as messages from "./messages";
import { intoMorph, intoStates, type Where } from "./morph";
import { pasted } from "./pasted";
import { mayHoldLink, tellFile, wordsForOther } from "./tell";
import { headOf } from "./tell-head";
import { weightsOf, weightsWords } from "./weights";

/** A file of several systems, of which one is to be chosen. */
export interface Choice {
  file: string;
  systems: readonly ImportedSystem[];
  remarks: readonly string[];
}

export const choice = signal<Choice | null>(null);

/** Nothing larger is read at all: of texts less is. */
const MOST_BYTES = 256 << 20;

/** Opens what comes in, until the returned function is called. */
export function listen(): () => void {
  const stops = [takeFiles((files) => void open(files)), listenForText()];
  return () => {
    for (const stop of stops) stop();
  };
}

/** A text that is pasted is a link, or what would be a file. In a text field it is the field's. */
function listenForText(): () => void {
  const onPaste = (event: ClipboardEvent) => {
    if (event.defaultPrevented || event.clipboardData?.files.length || takesText(event.target)) return;
    const got = pasted(event.clipboardData?.getData("text/plain") ?? "");
    if ("nothing" in got) return;
    event.preventDefault();
    if ("file" in got) openFile([got.file]);
    else if ("link" in got) openLink(got.link);
    else notify({ kind: "error", text: got.problem });
  };
  document.addEventListener("paste", onPaste);
  return () => document.removeEventListener("paste", onPaste);
}

const takesText = (target: EventTarget | null) => ["typing", "field"].includes(focusOf(target));

/** A link is opened as a step to undo; one that is cut off or cannot be read changes nothing. */
function openLink(sent: string): void {
  const { text, cutAfter } = arrived(sent);
  try {
    if (cutAfter !== null) throw new Error(messages.seemsToCutOff(cutAfter));
    openDecoded(text, messages.openedPastedLink);
  } catch (problem) {
    const why = messages.pastedLinkCannotOpened(wordsOf(problem));
    notify({ kind: "error", text: messages.workUnchanged(why) });
  }
}

async function open(files: readonly [File, ...File[]]): Promise<void> {
  const [first, ...others] = files;
  try {
    if (others.length === 0) await openOne(first);
    else await openSeveral(files);
  } catch (problem) {
    notify({ kind: "error", text: messages.fileFailed(first.name, wordsOf(problem)) });
  }
}

/** So many files at once are looked at. */
const MOST_FILES = 100;

/** The systems of all files with maps, to choose from; without such files the first is opened. What is left is said. */
async function openSeveral(files: readonly [File, ...File[]]): Promise<void> {
  const kinds = await Promise.all(
    files.slice(0, MOST_FILES).map(async (file) => ({ file, kind: tellFile(await headOf(file)) })),
  );
  const maps = kinds.filter(({ file, kind }) => kind === "maps" && file.size <= MOST_BYTES);
  const taken = new Set<File>(maps.length > 0 ? maps.map(({ file }) => file) : files.slice(0, 1));
  const left = files.filter((file) => !taken.has(file));
  if (left.length > 0) {
    const names = left.slice(0, 5).map(({ name }) => name);
    const more = left.length > names.length ? messages.andMore(left.length - names.length) : "";
    notify({ kind: "info", text: messages.notOpened(names.join(", "), more) });
  }
  const [only] = taken;
  if (taken.size === 1 && only) return openOne(only);
  const systems: ImportedSystem[] = [];
  const remarks: string[] = [];
  for (const file of taken) {
    try {
      const found = await imported(file);
      const name = file.name.replace(ENDING, "");
      systems.push(...found.systems.map((system) => ({ ...system, name: system.name || name })));
      remarks.push(...found.remarks.map((remark) => `${file.name}: ${remark}`));
      if (found.link !== undefined) remarks.push(messages.wholeDocument(file.name));
    } catch (problem) {
      remarks.push(`${file.name}: ${wordsOf(problem)}`);
    }
  }
  if (systems.length === 0) throw new Error(remarks.join(" "));
  choice.value = { file: messages.severalFiles(taken.size), systems, remarks };
}

const ENDING = /\.[a-z0-9]{1,8}$/i;

async function openOne(file: File): Promise<void> {
  if (file.size > MOST_BYTES) throw new Error(messages.fileLargerThan256);
  const head = await headOf(file);
  const kind = tellFile(head);
  switch (kind) {
    case "empty":
      throw new Error(messages.fileEmptyChooseAnother);
    case "other":
      throw new Error(wordsForOther(head));
    case "animation":
      return hand("space", file);
    case "picture":
      return openPicture(file, head);
    case "outline":
      return hand("fit", file);
    case "maps":
      return openMaps(file.name, await imported(file));
  }
}

async function imported(file: Blob): Promise<ImportedFile> {
  const exchange = await loadExchange();
  return exchange.importFile(new Uint8Array(await file.arrayBuffer()));
}

/** To a tool that reads it itself. */
async function hand(to: Tool, file: File): Promise<void> {
  const [from, step] = [tool.peek(), lastStep()];
  const { open } = await whenOpen(to);
  await open?.(file);
  cameFrom(from, step);
}

/** A picture that Frond saved is its document; any other is bent where pictures are bent, and else fitted. */
async function openPicture(file: File, head: Uint8Array): Promise<void> {
  const link = mayHoldLink(head) ? (await imported(file)).link : undefined;
  if (link !== undefined) openDocument(file.name, link);
  else await hand(tool.peek() === "deform" ? "deform" : "fit", file);
}

const openDocument = (name: string, link: string) =>
  openDecoded(arrived(link).text, messages.openedDocumentFrom(name));

function openDecoded(link: string, said: string): void {
  const { scene, problem } = frond.decodeScene(link);
  if (problem) throw problem;
  edit(() => scene);
  notify({ kind: "info", text: messages.undoable(said) });
}

function openMaps(file: string, { systems, remarks, link }: ImportedFile): void {
  const [first, ...others] = systems;
  if (link !== undefined) openDocument(file, link);
  else if (others.length > 0) choice.value = { file, systems, remarks };
  else if (first) void take(file, first, remarks);
}

/** Opens a system: of the plane in Morph, of space there. What was said of it is said once it is there. */
export async function take(
  file: string,
  system: ImportedSystem,
  remarks: readonly string[] = [],
  where: Where = "a",
): Promise<void> {
  const name = system.name || file.replace(ENDING, "") || messages.maps;
  const coloured = system.dimension === 2 && system.colours && where !== "b" ? [messages.coloursKept] : [];
  try {
    if (system.problem) throw new Error(system.problem);
    const said = [
      ...system.remarks,
      ...remarks,
      ...weightsWords(system),
      ...coloured,
      ...cameraWords(system),
    ].join(" ");
    if (system.dimension === 3) {
      const [from, step] = [tool.peek(), lastStep()];
      await whenOpen("space");
      const { takeAll, takeFound } = await import("#tools/space/shape/object/files");
      const view = system.camera ? solidView(system.camera) : null;
      if (system.objects) takeAll(name, system.objects, said, view);
      else takeFound({ name, maps: system.maps }, said, view);
      cameFrom(from, step);
    } else {
      const { maps, states, colours } = system;
      if (states) intoStates({ name, states }, where, said);
      else await intoMorph({ name, maps, weights: weightsOf(system), colours }, where, said);
      const seen = system.camera ? planeView(system.camera) : null;
      if (seen) await lookAt(seen);
    }
  } catch (problem) {
    notify({
      kind: "error",
      text: messages.cannotOpen(name, wordsOf(problem)),
    });
  }
}

/** Looks at a part of the plane. To look is nothing to undo. */
async function lookAt({ x, y, radius }: { x: number; y: number; radius: number }): Promise<void> {
  const { stageSize, view } = await import("#stage/view");
  const { width, height } = stageSize.peek();
  const across = Math.min(width, height);
  if (across > 0) view.value = { x, y, scale: across / (2 * radius) };
}

/** What can be done by a key: keyboard, help and tool tips come from the one list that a tool has. */
import { signal } from "@preact/signals";
import { canRedo, canUndo, redo, undo } from "#document/scene";
import { askForFile } from "./files/door";
import { type Focus, focusOf, type KeyPress, latinKey } from "./focus";
import * as messages from "./messages";

export interface Command {
  id: string;
  /** What it does, as help says it. */
  label: string;
  /** The heading in help. */
  group: string;
  /** Each is one way to press it, as help shows it: "G", "Shift+←", "Ctrl+Z". */
  keys: readonly string[];
  /** The key is taken all the same. */
  enabled?: () => boolean;
  /** `way` is the place of the key in `keys`. Without it a widget has these keys while it has the focus. */
  run?: (way: number) => void;
  /** The key is let go. */
  release?: () => void;
}

/** Whether the list of keys is open. */
export const help = signal(false);

/** In every tool. Some take back what is no part of the document first. */
export const everywhere = (back: Partial<Command> = {}, forth: Partial<Command> = {}): Command[] => [
  {
    id: "undo",
    label: messages.undo,
    group: messages.everywhere,
    keys: ["Z", "Ctrl+Z"],
    enabled: () => canUndo.value,
    run: undo,
    ...back,
  },
  {
    id: "redo",
    label: messages.redo,
    group: messages.everywhere,
    keys: ["Shift+Z", "Ctrl+Y", "Ctrl+Shift+Z"],
    enabled: () => canRedo.value,
    run: redo,
    ...forth,
  },
  {
    id: "open",
    label: messages.openFile,
    group: messages.everywhere,
    keys: ["Ctrl+O"],
    run: () => askForFile(),
  },
  {
    id: "help",
    label: messages.keyboardShortcuts,
    group: messages.everywhere,
    keys: ["?"],
    run: () => {
      help.value = true;
    },
  },
];

/** Keys that a widget has while it has the focus: each by its id, what it does, and how it is pressed. */
export const widgetKeys = (
  group: string,
  rows: readonly (readonly [id: string, label: string, ...keys: string[]])[],
): Command[] => rows.map(([id, label, ...keys]) => ({ id, label, group, keys }));

const NAMES: Record<string, string> = {
  ArrowLeft: "←",
  ArrowRight: "→",
  ArrowUp: "↑",
  ArrowDown: "↓",
  " ": messages.space,
  "-": "−",
};

/** A press as it is named in a list of keys, and without Shift, which says nothing where it is not in the list. */
function namesOf(press: KeyPress): string[] {
  const { ctrlKey, metaKey, shiftKey } = press;
  const key = latinKey(press);
  const name = NAMES[key] ?? (key.length === 1 ? key.toUpperCase() : key);
  const held = ctrlKey || metaKey ? "Ctrl+" : "";
  return shiftKey ? [`${held}Shift+${name}`, `${held}${name}`] : [held + name];
}

/** Who types has all keys, and a control those that it lives by. Alt is the browser's. */
function reaches({ key, ctrlKey, metaKey, altKey }: KeyPress, focus: Focus): boolean {
  if (focus === "typing" || altKey) return false;
  if (ctrlKey || metaKey) return true;
  if (key.startsWith("Arrow")) return focus === "none";
  if (key === " ") return focus === "none" || focus === "slider";
  return focus !== "field";
}

/** What a press asks for, and by which of its keys; null where it asks for nothing. */
export function commandOf(
  commands: readonly Command[],
  press: KeyPress,
  focus: Focus,
): { command: Command; way: number } | null {
  if (!reaches(press, focus)) return null;
  for (const name of namesOf(press)) {
    for (const command of commands) {
      const way = command.run ? command.keys.indexOf(name) : -1;
      if (way >= 0) return { command, way };
    }
  }
  return null;
}

/** What keys ask for now: nothing where nobody listens. */
const heard = signal<() => readonly Command[]>(() => []);

/** The command of that name in what keys ask for now, for a button that does the same. */
export const commandCalled = (id: string): Command | undefined =>
  heard.value().find((command) => command.id === id);

/** What a button says of itself, with the key of its command where it has one. */
export function withKey(words: string, id: string | undefined): string {
  const key = id === undefined ? undefined : commandCalled(id)?.keys[0];
  return key === undefined ? words : `${words} (${key})`;
}

/** Does what keys ask for, until the returned function is called. While a dialog is open they rest. */
export function listenForCommands(commands: () => readonly Command[]): () => void {
  heard.value = commands;
  const onKey = (event: KeyboardEvent) => {
    if (event.defaultPrevented || document.querySelector("dialog[open]") !== null) return;
    const found = commandOf(commands(), event, focusOf(event.target));
    if (!found) return;
    event.preventDefault();
    const { command, way } = found;
    if (command.enabled?.() !== false) command.run?.(way);
  };
  const onKeyUp = (event: KeyboardEvent) => {
    const key = latinKey(event).toUpperCase();
    for (const command of commands()) if (command.keys.includes(key)) command.release?.();
  };
  document.addEventListener("keydown", onKey);
  document.addEventListener("keyup", onKeyUp);
  return () => {
    heard.value = () => [];
    document.removeEventListener("keydown", onKey);
    document.removeEventListener("keyup", onKeyUp);
  };
}

/** The list by its headings, each once. */
export function groupsOf(commands: readonly Command[]): { title: string; commands: Command[] }[] {
  const groups = new Map<string, Command[]>();
  for (const command of commands) {
    const group = groups.get(command.group) ?? [];
    groups.set(command.group, group);
    group.push(command);
  }
  return [...groups].map(([title, commands]) => ({ title, commands }));
}

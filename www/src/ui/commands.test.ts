import { describe, expect, it, vi } from "vitest";
import { type Command, commandOf, everywhere, groupsOf, listenForCommands, withKey } from "./commands";
import type { Focus, KeyPress } from "./focus";
import { timeCommands } from "./strip/timeline";

const press = (key: string, held: Partial<KeyPress> = {}): KeyPress => ({
  key,
  code: "",
  shiftKey: false,
  ctrlKey: false,
  metaKey: false,
  altKey: false,
  ...held,
});

const sought: number[] = [];
const line = {
  now: () => 5,
  length: () => 10,
  seek: (moment: number) => void sought.push(moment),
  toggle: () => {},
  step: () => {},
  stop: "frame",
};
const commands: Command[] = [
  ...timeCommands(line),
  { id: "hint", label: "A handle's own", group: "Handle", keys: ["Delete", "K"] },
  { id: "key", label: "Add a keyframe", group: "Time", keys: ["K"], run: () => {} },
  { id: "colour", label: "Colour", group: "Picture", keys: ["1", "2"], run: () => {} },
  ...everywhere(),
];
const asked = (key: KeyPress, focus: Focus) => {
  const found = commandOf(commands, key, focus);
  return found && `${found.command.id} ${found.way}`;
};

describe("commandOf", () => {
  it.each([
    // A control keeps the keys that it lives by.
    [press(" "), "none", "play 0"],
    [press(" "), "slider", "play 0"],
    [press(" "), "control", null],
    [press("ArrowLeft"), "none", "scrub 0"],
    [press("ArrowLeft"), "slider", null],
    [press("ArrowLeft"), "control", null],
    [press("ArrowRight", { shiftKey: true }), "none", "scrub-finely 1"],
    [press("]"), "none", "step 1"],
    // Who types has all keys, and a field where nothing typed waits leaves the chords.
    ...[" ", "z", "ArrowLeft", "?", "1", "k"].flatMap((key): [KeyPress, Focus, null][] => [
      [press(key), "typing", null],
      [press(key), "field", null],
    ]),
    [press("z", { ctrlKey: true }), "typing", null],
    [press("z", { ctrlKey: true }), "field", "undo 1"],
    // By letter and by chord.
    [press("z"), "none", "undo 0"],
    [press("z", { metaKey: true }), "control", "undo 1"],
    [press("Z", { shiftKey: true }), "none", "redo 0"],
    [press("y", { ctrlKey: true }), "none", "redo 1"],
    [press("Z", { ctrlKey: true, shiftKey: true }), "none", "redo 2"],
    [press("?", { shiftKey: true }), "none", "help 0"],
    // Under layouts of other letters the place of the key counts: Russian, Greek and Hebrew.
    [press("я", { code: "KeyZ", ctrlKey: true }), "none", "undo 1"],
    [press("Я", { code: "KeyZ", shiftKey: true }), "none", "redo 0"],
    [press("ζ", { code: "KeyZ" }), "none", "undo 0"],
    [press("ז", { code: "KeyZ", metaKey: true }), "none", "undo 1"],
    [press("л", { code: "KeyK" }), "none", "key 0"],
    [press(",", { code: "Slash", shiftKey: true }), "none", "help 0"],
    // Under a German or French one the letter does.
    [press("z", { code: "KeyY", ctrlKey: true }), "none", "undo 1"],
    [press("y", { code: "KeyZ", ctrlKey: true }), "none", "redo 1"],
    [press("z", { code: "KeyW" }), "none", "undo 0"],
    [press("ü", { code: "BracketLeft" }), "none", "step 0"],
    [press("é", { code: "Digit2" }), "none", null],
    [press("K", { shiftKey: true }), "control", "key 0"],
    [press("2"), "none", "colour 1"],
    // Chords of the browser, and what a widget has for itself.
    ...["k", "1", "ArrowLeft", " ", "["].flatMap((key): [KeyPress, Focus, null][] => [
      [press(key, { ctrlKey: true }), "none", null],
      [press(key, { altKey: true }), "none", null],
    ]),
    [press("Delete"), "none", null],
    [press("q"), "none", null],
  ] as [KeyPress, Focus, string | null][])("%o with the focus on %s asks for %s", (key, focus, command) => {
    expect(asked(key, focus)).toBe(command);
  });
});

it("scrubs by parts of the length", () => {
  for (const key of [press("ArrowLeft"), press("ArrowRight", { shiftKey: true })]) {
    const found = commandOf(commands, key, "none");
    found?.command.run?.(found.way);
  }
  expect(sought).toEqual([4.9, 5.01]);
});

it("lists all by their headings, each once", () => {
  const groups = groupsOf(commands);
  expect(groups.map(({ title }) => title)).toEqual(["Time", "Handle", "Picture", "Everywhere"]);
  expect(groups.flatMap(({ commands }) => commands)).toHaveLength(commands.length);
});

describe("withKey", () => {
  it("names the key of a command while keys are listened for, and no other", () => {
    vi.stubGlobal("document", new EventTarget());
    expect(withKey("Play", "play")).toBe("Play");
    const stop = listenForCommands(() => commands);
    expect(withKey("Play", "play")).toBe("Play (Space)");
    expect(withKey("Play", "none such")).toBe("Play");
    expect(withKey("Play", undefined)).toBe("Play");
    stop();
    expect(withKey("Play", "play")).toBe("Play");
    vi.unstubAllGlobals();
  });
});

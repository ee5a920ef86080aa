import { describe, expect, it, vi } from "vitest";
import { replaceFit } from "#document/fit";
import { commandsOf } from "#stage/tool";
import type { Command } from "#ui/commands";
import type { Timeline } from "#ui/strip/timeline";
import { TOOLS } from "./tools";

vi.mock("#wasm/core", () => ({ frond: {} }));

/** Every tool lists its commands in a file of this name; where the list hangs on the document, it is a function. */
const files = import.meta.glob<{
  commands: readonly Command[] | (() => readonly Command[]);
  timeline?: Timeline;
}>("../tools/*/commands.ts", { eager: true });

const NO_FILMS = async () => ({ subjects: [] });

const listsNow = (when = ""): [string, readonly Command[]][] =>
  Object.entries(files).map(([file, { commands, ...time }]) => [
    `${file.split("/").at(-2)}${when}`,
    commandsOf({
      ...time,
      films: NO_FILMS,
      commands: typeof commands === "function" ? commands : () => commands,
    }),
  ]);

const lists = listsNow();
replaceFit((now) => ({ ...now, mode: "graph" }));
lists.push(...listsNow(" with a graph").filter(([name]) => name.startsWith("fit")));
replaceFit((now) => ({ ...now, mode: "outline" }));

it("are those of all tools", () => {
  expect(Object.keys(files)).toHaveLength(TOOLS.length);
});

it("have the keys of time where something moves", () => {
  const playing = lists.filter(([, commands]) => commands.some(({ id }) => id === "play"));
  expect(playing.map(([name]) => name)).toEqual(["deform", "morph", "space"]);
});

describe.each(lists)("the keys of %s", (_, commands) => {
  it("do one thing each", () => {
    const keys = commands.flatMap((command) => (command.run ? command.keys : []));
    expect(keys).toHaveLength(new Set(keys).size);
  });
  it("name each thing once", () => {
    for (const list of [
      commands.map(({ id }) => id),
      commands.map(({ group, label }) => `${group}: ${label}`),
    ]) {
      expect(list).toHaveLength(new Set(list).size);
    }
  });
});

describe("the same key", () => {
  const keys = lists.flatMap(([, commands]) =>
    commands.flatMap(({ id, keys, run }) => (run ? keys : []).map((key) => [key, id] as const)),
  );
  it.each([...new Set(keys.map(([key]) => key))])("%s means the same in every tool", (key) => {
    const meanings = new Set(keys.filter(([other]) => other === key).map(([, id]) => id));
    expect([...meanings]).toHaveLength(1);
  });
});

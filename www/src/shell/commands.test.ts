import { describe, expect, it, vi } from "vitest";
import { replaceFit } from "#document/fit";
import type { Command } from "#ui/commands";

vi.mock("#wasm/core", () => ({ frond: {} }));
const { commands: morph } = await import("#tools/morph/commands");
const { commands: deform } = await import("#tools/deform/commands");
const { commands: ofFit } = await import("#tools/fit/commands");
const { commands: space } = await import("#tools/space/commands");

const graph = () => {
  replaceFit((now) => ({ ...now, mode: "graph" }));
  const commands = ofFit();
  replaceFit((now) => ({ ...now, mode: "outline" }));
  return commands;
};
const lists: [string, readonly Command[]][] = Object.entries({
  morph,
  deform,
  fit: ofFit(),
  graph: graph(),
  space,
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
    expect(new Set(keys.filter(([other]) => other === key).map(([, id]) => id)).size).toBe(1);
  });
});

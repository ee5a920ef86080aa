/** Styles of tools are loaded when their tool is opened, and stay: what they say must not reach anybody else's elements. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";

const root = fileURLToPath(new URL("../../www/src", import.meta.url));
const LAZY = ["tools/deform", "tools/fit", "tools/space", "curve"];

const files = readdirSync(root, { recursive: true, encoding: "utf8" })
  .filter((path) => /\.(css|tsx)$/.test(path))
  .map((path) => {
    const room = LAZY.find((folder) => path.startsWith(`${folder}/`)) ?? path.split("/")[0];
    const text = readFileSync(join(root, path), "utf8").replace(/\/\*[\s\S]*?\*\//g, "");
    return { path, room, text, css: path.endsWith(".css") };
  });

/** The selectors of a sheet, one by one. */
function selectorsOf(text: string): string[] {
  return [...text.matchAll(/([^{};]+)\{/g)]
    .map(([, selector = ""]) => selector.trim())
    .filter((selector) => !/^(@|from$|to$|\d)/.test(selector))
    .flatMap((selector) => selector.split(/,(?![^(]*\))/).map((one) => one.trim().replace(/\s+/g, " ")));
}

/** Classes and data attributes: what a selector may be known by. */
const namesIn = (selector: string) =>
  [...selector.matchAll(/[.[]((?:data-)?[a-zA-Z_][\w-]*)/g)].map(([, name = ""]) => name);

/** Who speaks of each name. */
const rooms = new Map<string, Set<string>>();
for (const { room = "", text, css } of files) {
  const names = css
    ? selectorsOf(text).flatMap(namesIn)
    : [...text.matchAll(/\b(?:class=(?:"([^"]*)"|\{`([^`]*)`\})|(data-[a-z-]+)=)/g)].flatMap(
        ([, plain, made, data]) => (plain ?? made ?? data ?? "").split(/[^\w-]+/),
      );
  for (const name of names) rooms.set(name, (rooms.get(name) ?? new Set()).add(room));
}

describe("styles that are loaded with a tool", () => {
  it.each(LAZY)("are known by a name of their own: %s", (folder) => {
    const own = (name: string) => [...(rooms.get(name) ?? [])].every((room) => room === folder);
    const bare = files
      .filter(({ room, css }) => css && room === folder)
      .flatMap(({ text }) => selectorsOf(text))
      .filter((selector) => !namesIn(selector).some(own));
    expect(bare).toEqual([]);
  });
});

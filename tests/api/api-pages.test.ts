/** The pages of the package's functions: nothing that it exports is missing, and no link leads nowhere. */
import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";
import { apiPages, sampleOf, surface } from "../../www/build/api/pages";
import { declarations } from "../../www/build/api/read";
import { wrapped } from "../../www/build/api/wrapped";

const at = (path: string) => fileURLToPath(new URL(`../../${path}`, import.meta.url));
const pages = apiPages();
const page = (name: string) => pages.find(({ path }) => path === `api/${name}.html`)?.content ?? "";

it.each([
  ["draw", "frond"],
  ...["curve", "proof", "exact", "fit", "space", "directed", "exchange", "morph"].map((name) => [
    name,
    `frond-${name}`,
  ]),
  ["renderer", "renderer"],
])("%s has all that its module exports", (name, file) => {
  const text = readFileSync(at(`www/pkg/${file}.d.ts`), "utf8");
  const exported = [...text.matchAll(/^export (?:function|class) (\w+)/gm)].map(([, one]) => one);
  const named = exported.filter((one) => !/^(?:start|initSync)$/.test(one ?? ""));
  expect(named.length).toBeGreaterThan(0);
  for (const one of named) {
    expect(page(name ?? ""), one).toContain(`id="${one}"`);
    expect(page("index"), one).toContain(`href="./${name}.html#${one}"`);
  }
});

it("link to nothing that is not there, and name each place once", () => {
  const ids = new Map(
    pages.map(({ path, content }) => [path, [...content.matchAll(/ id="([^"]+)"/g)].map(([, id]) => id)]),
  );
  for (const [path, own] of ids) expect(new Set(own).size, path).toBe(own.length);
  for (const { path, content } of pages)
    for (const [, to, id] of content.matchAll(/href="\.\/([\w-]+\.html)(?:#([^"]+))?"/g)) {
      expect([...ids.keys()], `${path}: ${to}`).toContain(`api/${to}`);
      if (id) expect(ids.get(`api/${to}`), `${path}: ${to}`).toContain(id);
    }
});

it("link to functions that a comment names, and not where it means an argument", () => {
  expect(page("directed")).toContain('as <a href="./draw.html#rasterize"><code>rasterize</code></a> does');
  expect(page("proof")).toContain("computed already, over <code>bounds</code>");
});

it("show each sample where its function is", () => {
  const names = readdirSync(at("www/build/api/samples")).map((file) => file.replace(/\.js$/, ""));
  expect(names.length).toBeGreaterThanOrEqual(15);
  const all = pages.map(({ content }) => content).join("");
  for (const name of names) expect(all.split(`data-sample="${name}"`).length - 1, name).toBe(1);
  expect(surface().entries.flatMap(({ declared }) => declared.map(({ name }) => name))).toEqual(
    expect.arrayContaining(names),
  );
  expect(sampleOf("nothing")).toBeNull();
  expect(() => wrapped("await init();\n")).toThrow("begins with its imports");
});

it("read declarations with braces, strings and comments in them", () => {
  const found = declarations(
    `
    export type Odd =
    | { kind: "a;b" }
    /** A comment with a } in it. */
    | { kind: "c" };
    /** Says \`x\`. */
    export function f(x: { y: number; }, g: () => void): { z: string };
    export class Point {
        free(): void;
        /** How far. */
        far(x: number): number;
        far(x: number, y: number): number;
        /** Its name. */
        get name(): string;
        set name(text: string);
    }
    export function initSync(): void;`.replace(/^ {4}/gm, ""),
  );
  expect(found.map(({ name, kind, about }) => [name, kind, about])).toEqual([
    ["Odd", "type", ""],
    ["f", "function", "Says `x`."],
    ["Point", "class", ""],
  ]);
  expect(found[0]?.code).toMatch(/"c" };$/);
  expect(found[1]?.code).toBe("function f(x: { y: number; }, g: () => void): { z: string };");
  expect(found[2]?.members.map(({ name, about }) => [name, about])).toEqual([
    ["far", "How far."],
    ["name", "Its name."],
  ]);
  expect(found[2]?.members[1]?.code).toBe("get name(): string;\nset name(text: string);");
  expect(() => declarations("export interface X {")).toThrow("cannot be read");
});

/** Styles of tools are loaded when their tool is opened, and stay: they must not reach anybody else's elements. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { NIGHT, PAPER } from "../../www/src/style/colours";

const root = fileURLToPath(new URL("../../www/src", import.meta.url));
const tools = readdirSync(join(root, "tools")).filter((tool) => tool !== "morph");
const LAZY = [...tools.map((tool) => `tools/${tool}`), "curve"];

const files = readdirSync(root, { recursive: true, encoding: "utf8" })
  .filter((path) => /\.(css|tsx?)$/.test(path))
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

/** What is drawn over a picture has its form from `form`: a page's own would move one against the other. */
it("no page gives a picture another form than what is drawn over it", () => {
  const folderOf = (path: string) => path.replace(/\/[^/]*$/, "");
  const pages = files.filter(({ path }) => /^figures\/(?!kit\/)[^/]+\//.test(path));
  const drawn = new Set(pages.filter(({ text }) => /<Drawn\b/.test(text)).map(({ path }) => folderOf(path)));
  const own = pages.filter(({ css, text }) => css && text.includes("--picture-aspect"));
  expect(drawn.size).toBeGreaterThan(5);
  expect(own.length).toBeGreaterThan(0);
  expect(own.map(({ path }) => folderOf(path)).filter((folder) => drawn.has(folder))).toEqual([]);
});

/** Names of classes from a module: `css["name"]`, where `css` is what the file imports that module as. */
const importedModules = (text: string) => [...text.matchAll(/import (\w+) from "([.#][^"]+\.module\.css)"/g)];
const modules = new Map(
  files.filter(({ path }) => path.endsWith(".module.css")).map(({ path, text }) => [path, text]),
);

describe("modules of style", () => {
  const used = new Set<string>();
  const missing: string[] = [];
  for (const { path, text } of files.filter(({ css }) => !css)) {
    for (const [, name = "", from = ""] of importedModules(text)) {
      const module = from.startsWith("#") ? from.slice(1) : join(path, "..", from);
      const known = new Set(selectorsOf(modules.get(module) ?? "").flatMap(namesIn));
      const uses = [...text.matchAll(new RegExp(`\\b${name}\\[(?:"([^"]+)"|[^\\]]+)\\]`, "g"))];
      for (const [whole, asked] of uses) {
        used.add(`${module} ${asked ?? "*"}`);
        if (asked !== undefined && !known.has(asked)) missing.push(`${path}: ${whole}`);
      }
      if (!modules.has(module) || uses.length === 0) missing.push(`${path}: ${from}`);
    }
  }

  it("have every class that is asked of them", () => expect(missing).toEqual([]));

  it.each([...modules])(
    "%s has no class that nobody asks for, and no selector without a class",
    (path, text) => {
      const selectors = selectorsOf(text.replace(/:global\([^)]*\)/g, ""));
      const unused = selectors
        .flatMap(namesIn)
        .filter((name) => !/^(data|aria)-|^type$/.test(name) && !used.has(`${path} ${name}`));
      // Some names are chosen while the page runs: `css[kind]`.
      if (!used.has(`${path} *`)) expect([...new Set(unused)]).toEqual([]);
      const ownData = (name: string) => name.startsWith("data-") && rooms.get(name)?.size === 1;
      const bare = selectors.filter(
        (selector) => !/\.[a-z]/.test(selector) && !namesIn(selector).some(ownData),
      );
      expect(bare).toEqual([]);
    },
  );
});

/** Words that several rooms share, or refine for themselves; ARCHITECTURE.md says what they are. */
const SHARED: Record<string, string> = {
  "style/": "base element layout locus print stage tokens",
  "stage/locus/": "handles locus path",
  "ui/controls/": "button choice field hold-button select slider",
  "ui/files/": "drop-files",
  "ui/overlay/": "overlay",
  "ui/panel/": "fold panel progress",
  "ui/shapes/": "subject-card thumbnail verdict-sign",
  "ui/strip/": "key-track play-button strip",
  // What the tool of morphs refines of them.
  "tools/morph/locus/": "field",
  "tools/morph/strip/": "strip",
  // What becomes of all of these on paper, and on slides.
  "figures/lessons/frame/slides/": "slides",
  "figures/lessons/frame/handout/": "handout",
};

it("has no style outside of modules but of words that rooms share", () => {
  const plain = files.filter(({ path, css }) => css && !path.endsWith(".module.css")).map(({ path }) => path);
  const shared = Object.entries(SHARED).flatMap(([folder, names]) =>
    names.split(" ").map((name) => `${folder}${name}.css`),
  );
  expect(plain.sort()).toEqual(shared.sort());
});

/** What paints a picture of its own, as a photograph has its colours. */
const PAINTED = ["document/deform/sample-picture.ts"];

it("has colours in the room of styles alone", () => {
  const HEX = /#(?:[0-9a-f]{8}|[0-9a-f]{6}|[0-9a-f]{3,4})(?![\w-])/.source;
  const FUNCTION = /(?:rgb|hsl|hwb|oklab|oklch|lab|lch|color)a?\(/.source;
  const inSheets = new RegExp(`${HEX}|\\b${FUNCTION}`, "gi");
  const inStrings = new RegExp(`(?<=["'\`(,:] ?)(?:${HEX}(?! ?[(=])|${FUNCTION}(?=[\\d$]))`, "gi");
  const found = files
    .filter(({ path, room }) => room !== "style" && !/\.test\./.test(path) && !PAINTED.includes(path))
    .flatMap(({ path, text, css }) =>
      [...text.matchAll(css ? inSheets : inStrings)].map(([colour]) => `${path}: ${colour}`),
    );
  expect(found).toEqual([]);
});

it("calls the grounds of documents as the stages of the two themes", () => {
  const tokens = files.find(({ path }) => path === "style/tokens.css")?.text ?? "";
  const stages = [...tokens.matchAll(/--stage: (#\w+)/g)].map(([, colour]) => colour);
  expect(stages).toEqual([PAPER, NIGHT, NIGHT]);
});

it("has no class in a plain sheet that no component speaks of", () => {
  const page = readFileSync(join(root, "../../index.html"), "utf8");
  const words = new Set(
    [page, ...files.filter(({ css }) => !css).map(({ text }) => text)].join(" ").split(/[^\w-]+/),
  );
  const unused = files
    .filter(({ path, css }) => css && !path.endsWith(".module.css"))
    .flatMap(({ path, text }) =>
      selectorsOf(text).flatMap((selector) => namesIn(selector).map((name) => [path, name])),
    )
    .filter(([, name = ""]) => !name.startsWith("data-") && name !== "type" && !words.has(name));
  expect(unused).toEqual([]);
});

it("has no class in a component that no sheet and no test speaks of", () => {
  const known = new Set(
    files.filter(({ css }) => css).flatMap(({ text }) => selectorsOf(text).flatMap(namesIn)),
  );
  const tests = readdirSync(join(root, "../../tests/e2e"))
    .filter((name) => name.endsWith(".ts"))
    .map((name) => readFileSync(join(root, "../../tests/e2e", name), "utf8"))
    .join("\n");
  const unknown = files
    .filter(({ path }) => path.endsWith(".tsx"))
    .flatMap(({ path, text }) =>
      [...text.matchAll(/\bclass=(?:"([^"]*)"|\{`([^`]*)`\})/g)]
        .flatMap(([, plain, made]) => (plain ?? made?.replace(/\$\{[^}]*\}/g, " ") ?? "").split(/\s+/))
        .filter((name) => name !== "" && !known.has(name) && !tests.includes(`.${name}`))
        .map((name) => `${path}: ${name}`),
    );
  expect(unknown).toEqual([]);
});

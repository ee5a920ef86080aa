/** What a person reads stands in catalogues, `messages.ts` beside the code of a room, and each of them is used. */
import { readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseAst } from "vite";
import { expect, it } from "vitest";

const root = fileURLToPath(new URL("../../www/src", import.meta.url));
const files = readdirSync(root, { recursive: true, encoding: "utf8" })
  .map((path) => path.replaceAll("\\", "/"))
  .filter((path) => /\.tsx?$/.test(path) && !/\.test\.|\.d\.ts$/.test(path));
const texts = new Map(files.map((path) => [path, readFileSync(join(root, path), "utf8")]));

/** The rooms whose sentences all stand in catalogues. A room is added once it is done, and never leaves. */
const DONE = [
  "compute",
  "curve",
  "directed",
  "document",
  "film",
  "format",
  "geometry",
  "shell",
  "stage",
  "tools/deform",
  "tools/fit",
  "tools/morph",
  "tools/space",
  "ui",
];

/** Attributes and properties that a person reads or hears. */
const READ =
  /^(title|alt|label|placeholder|about|hint|description|text|valueText|unit|aria-(label|description|valuetext|roledescription|placeholder))$/;
/** The same words may be a name for programs. Those of elements are never read. */
const CODES = /^(name|text|unit)$/;

/** Two words, or more: a code has none. */
const SENTENCE = /\p{L}[,.:;]? +\p{L}/u;
const WORD = /\p{L}{2}/u;
/** A name of another program, of a format, or of Frond, or a symbol: the same in all languages. */
const UNTRANSLATED = /^\s*(Frond|Re s|Im s|PNG|GIF|SVG|STL|OBJ|ZIP|WebM|MP4|APNG|JSON|CSV|PLY|glTF|mm)\s*$/;

interface Node {
  type: string;
  start: number;
  [key: string]: unknown;
}

const isNode = (value: unknown): value is Node =>
  typeof value === "object" && value !== null && typeof (value as Node).type === "string";

/** Where a text of a file is, and what it says. */
interface Bare {
  line: number;
  text: string;
}

/** The texts in a file that a person reads and that no catalogue holds. */
function bareTexts(path: string, code: string): Bare[] {
  const found: Bare[] = [];
  const say = ({ start }: Node, text: string) =>
    found.push({ line: code.slice(0, start).split("\n").length, text: text.trim() });
  const nameOf = (node: unknown): string => {
    if (!isNode(node)) return "";
    return typeof node["name"] === "string" ? node["name"] : String(node["value"] ?? nameOf(node["name"]));
  };
  const look = (node: Node, within: string): void => {
    switch (node.type) {
      case "ImportDeclaration":
      case "ExportAllDeclaration":
      case "TSLiteralType":
      case "TaggedTemplateExpression":
        return;
      case "BinaryExpression":
        // What is only compared is a code.
        if (/^[!=]=/.test(node["operator"] as string)) return;
        break;
      case "JSXText":
        if (WORD.test(node["value"] as string) && !UNTRANSLATED.test(node["value"] as string))
          say(node, node["value"] as string);
        return;
      case "Literal": {
        const text = node["value"];
        if (typeof text !== "string" || UNTRANSLATED.test(text)) return;
        const named = within === "name";
        if (
          READ.test(within) ? WORD.test(text) : SENTENCE.test(text) && (named || /\p{Lu}|[.!?…]$/u.test(text))
        )
          say(node, text);
        return;
      }
      case "TemplateElement": {
        const text = (node["value"] as { cooked: string }).cooked;
        if (READ.test(within) ? WORD.test(text) : SENTENCE.test(text)) say(node, text);
        return;
      }
    }
    const inside =
      node.type === "JSXAttribute"
        ? nameOf(node["name"])
        : node.type === "Property" && node["computed"] !== true && !CODES.test(nameOf(node["key"]))
          ? nameOf(node["key"])
          : node.type === "CallExpression" || node.type === "ArrowFunctionExpression"
            ? ""
            : within;
    // Names of elements, of styles and of addresses are for programs.
    if (
      /^(class|style|href|src|d|viewBox|transform|type|role|id|key|rel|accept|fill|stroke)$/.test(inside) &&
      node.type === "JSXAttribute"
    )
      return;
    for (const [key, value] of Object.entries(node)) {
      if (key === "key" && node.type === "Property") continue;
      for (const child of Array.isArray(value) ? value : [value]) if (isNode(child)) look(child, inside);
    }
  };
  look(parseAst(code, { lang: path.endsWith("x") ? "tsx" : "ts" }) as unknown as Node, "");
  return found;
}

/** Texts for programs that look like sentences, each with the file or folder that it is in. */
const FOR_PROGRAMS: readonly (readonly [where: string, text: RegExp])[] = [
  // HTML that somebody copies or downloads.
  ["shell/publish/ShareDialog.tsx", /<|style=/],
  ["shell/publish/folder.ts", /[<>{}]|^light dark$|^autoplay loop$/],
  // Names of gestures.
  ["tools/deform/mesh/GridPanel.tsx", /^mesh field$/],
  ["tools/deform/mesh/keyboard.ts", /^mesh keys$/],
  ["stage/handles/held.ts", /^turn keys$/],
  ["tools/space/", /^(bend (size|move)|space key)$/],
  ["tools/fit/", /^(drag|keys) (factor|knot|point)$/],
  // Data of a file, and a symbol.
  ["tools/fit/save.ts", /^collage /],
  ["tools/fit/panel/facts.tsx", /^dD$/],
  // A page that shows all widgets to developers.
  ["ui/widgets/", /./],
  // What browsers and files say.
  ["ui/drawing/", /^(id x y|pattern|marker|pathLength|xMidYMid)/],
  ["shell/trouble.ts", /^ResizeObserver loop$/],
  ["shell/door/tell.ts", /^iTXtFrond link/],
];

it("holds every text of the rooms that are done", () => {
  const bare = files
    .filter((path) => DONE.some((room) => path.startsWith(`${room}/`)) && !path.endsWith("/messages.ts"))
    .flatMap((path) =>
      bareTexts(path, texts.get(path) ?? "")
        .filter(
          ({ text }) => !FOR_PROGRAMS.some(([where, known]) => path.startsWith(where) && known.test(text)),
        )
        .map(({ line, text }) => `${path}:${line}: ${text}`),
    );
  expect(bare).toEqual([]);
});

it("finds text in elements, attributes and calls", () => {
  const code = `
    const a = <p title="Two words" class="two words">Bare</p>;
    say("This is one.", \`and \${n} more of them\`);
    const item = { label: "Open", kind: "open file" };
  `;
  expect(bareTexts("a.tsx", code).map(({ text }) => text)).toEqual([
    "Two words",
    "Bare",
    "This is one.",
    "more of them",
    "Open",
  ]);
});

/** Files that import a catalogue, by the path of that. */
function readersOf(catalogue: string): string[] {
  return files.filter((path) =>
    [...(texts.get(path) ?? "").matchAll(/import \* as messages from "([^"]+)"/g)].some(([, from = ""]) => {
      const found = from.startsWith("#") ? from.slice(1) : join(dirname(path), from).replaceAll("\\", "/");
      return `${found}.ts` === catalogue;
    }),
  );
}

it("has no message that nobody says, and none twice under one name", () => {
  const catalogues = files.filter((path) => path.endsWith("/messages.ts"));
  expect(catalogues.length).toBeGreaterThan(5);
  const idle = catalogues.flatMap((path) => {
    const own = texts.get(path) ?? "";
    const readers = readersOf(path).map((reader) => texts.get(reader) ?? "");
    return [...own.matchAll(/^export const (\w+)/gm)]
      .map(([, name = ""]) => name)
      .filter((name) => !readers.some((text) => new RegExp(`\\bmessages\\.${name}\\b`).test(text)))
      .map((name) => `${path}: ${name}`);
  });
  expect(idle).toEqual([]);
});

it("has every message that is said", () => {
  const missing = files
    .filter((path) => path.endsWith("/messages.ts"))
    .flatMap((path) =>
      readersOf(path).flatMap((reader) =>
        [...(texts.get(reader) ?? "").matchAll(/\bmessages\.(\w+)/g)]
          .map(([, name = ""]) => name)
          .filter((name) => !new RegExp(`^export const ${name}\\b`, "m").test(texts.get(path) ?? ""))
          .map((name) => `${reader}: ${name}`),
      ),
    );
  expect(missing).toEqual([]);
});

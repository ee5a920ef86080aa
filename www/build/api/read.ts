/** What a file of declarations, as wasm-bindgen writes them, exports: in its order, each with its comment. */

export interface Member {
  name: string;
  /** As markdown. */
  about: string;
  /** As it is declared, without its comment. */
  code: string;
}

export interface Declared extends Member {
  kind: "function" | "class" | "type";
  /** Of a class. */
  members: Member[];
}

const OPEN = "{([";
const CLOSE = "})]";

/** Where what begins at `start` ends: after the `;`, or the brace, that is of no inner part. */
function endOf(text: string, start: number): number {
  let depth = 0;
  for (let i = start; i < text.length; i++) {
    const c = text[i] ?? "";
    if (text.startsWith("/*", i)) i = text.indexOf("*/", i) + 1;
    else if (text.startsWith("//", i)) i = text.indexOf("\n", i) - 1;
    else if (c === '"' || c === "'") i = text.indexOf(c, i + 1);
    else if (OPEN.includes(c)) depth++;
    else if (CLOSE.includes(c)) {
      depth--;
      // A block, and no type that goes on.
      if (
        depth === 0 &&
        c === "}" &&
        /^\s*(?:\/\*|export |declare |import |$)/.test(text.slice(i + 1, i + 80))
      )
        return text[i + 1] === ";" ? i + 2 : i + 1;
    } else if (c === ";" && depth === 0) return i + 1;
  }
  throw new Error(`a declaration does not end: ${text.slice(start, start + 80)}`);
}

const prose = (comment: string) =>
  comment
    .replace(/^\/\*\*|\*\/$/g, "")
    .split("\n")
    .map((line) => line.replace(/^\s*\* ?/, "").trimEnd())
    .join("\n")
    .trim();

/** The parts of a text one after the other, each with the comment before it. */
function parts(text: string): { about: string; code: string }[] {
  const found = [];
  let about = "";
  for (let i = 0; i < text.length; ) {
    const space = /\s*/y;
    space.lastIndex = i;
    space.test(text);
    i = space.lastIndex;
    if (i >= text.length) break;
    if (text.startsWith("//", i)) i = text.indexOf("\n", i) + 1 || text.length;
    else if (text.startsWith("/*", i)) {
      const end = text.indexOf("*/", i) + 2;
      about = text.startsWith("/**", i) ? prose(text.slice(i, end)) : "";
      i = end;
    } else {
      const end = endOf(text, i);
      found.push({ about, code: text.slice(i, end).trim() });
      about = "";
      i = end;
    }
  }
  return found;
}

/** What is of the module itself, and not of what it does. */
const OF_MODULE = /^(?:InitInput|InitOutput|SyncInitInput|initSync|start|__\w+)$/;
const OF_MEMORY = /^(?:free\(|\[Symbol\.dispose\]|private constructor)/;

/** What is declared several times, as a property that is read and written or a function of several forms, is one. */
function merged<T extends Member>(all: T[]): T[] {
  const byName = new Map<string, T>();
  for (const one of all) {
    const before = byName.get(one.name);
    if (!before) byName.set(one.name, one);
    else {
      const about = [before.about, one.about].filter((text, i, both) => text && both.indexOf(text) === i);
      byName.set(one.name, { ...before, about: about.join("\n\n"), code: `${before.code}\n${one.code}` });
    }
  }
  return [...byName.values()];
}

export function declarations(text: string): Declared[] {
  const all = parts(text).flatMap(({ about, code }): Declared[] => {
    const [, word = "", name = ""] =
      /^export (?:declare )?(?:default )?(function|class|interface|type) (\w+)/.exec(code) ?? [];
    if (!name || OF_MODULE.test(name)) return [];
    const plain = code.replace(/^export (?:declare )?(?:default )?/, "").replace(/^ {4}/gm, "  ");
    if (word !== "class") return [{ name, about, code: plain, members: [], kind: kindOf(word) }];
    const body = code.slice(code.indexOf("{") + 1, code.lastIndexOf("}"));
    const members = parts(body).flatMap((member) => {
      const known = /^(?:static |readonly |get |set )*(\w+)/.exec(member.code)?.[1];
      return !known || OF_MEMORY.test(member.code) ? [] : [{ ...member, name: known }];
    });
    return [{ name, about, code: `class ${name}`, members: merged(members), kind: "class" }];
  });
  return merged(all);
}

const kindOf = (word: string) => (word === "function" ? "function" : "type");

/** What a file of declarations exports, for its page: in its order, each with its comment. */
import { exportedIn } from "../declared.ts";

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

const prose = (comment: string) =>
  !comment.startsWith("/**")
    ? ""
    : comment
        .replace(/^\/\*\*|\*\/$/g, "")
        .split("\n")
        .map((line) => line.replace(/^\s*\* ?/, "").trimEnd())
        .join("\n")
        .trim();

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
  const all = exportedIn(text).flatMap((one): Declared[] => {
    const { name, node } = one;
    if (OF_MODULE.test(name)) return [];
    const about = prose(one.comment);
    if (node.type === "ClassDeclaration") {
      const members = one.members.flatMap(({ name, comment, start, end }) => {
        const code = text.slice(start, end);
        return OF_MEMORY.test(code) ? [] : [{ name, about: prose(comment), code }];
      });
      return [{ name, about, code: `class ${name}`, members: merged(members), kind: "class" }];
    }
    const code = text.slice(one.start, one.end);
    const plain = code.replace(/^export (?:declare )?(?:default )?/, "").replace(/^ {4}/gm, "  ");
    const kind = node.type === "TSDeclareFunction" ? "function" : "type";
    return [{ name, about, code: plain, members: [], kind }];
  });
  return merged(all);
}

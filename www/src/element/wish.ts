/** What the attributes of a `<frond-view>` ask for, in words where it cannot be had. */
import { FrondError } from "./trouble";
import { isOn } from "./values";

export interface Wish {
  /** The document: what stands behind the # of a link. */
  fragment: string;
  /** Drawn here, shown by the studio in a frame, or a page of its figures. */
  where: "here" | "studio" | "figure";
  /** What could not be understood, and was left out. */
  troubles: WishError[];
}

/** Reads attributes by name; null stands for one that is not there. */
export type Read = (name: string) => string | null;

/** What is told to whoever wrote the page. */
export class WishError extends FrondError {
  /** Which attribute it is about. */
  readonly attribute: string;

  constructor(attribute: string, message: string) {
    super("attribute", message);
    this.attribute = attribute;
  }
}

/** The attributes that are read here. */
export const WISHES = ["src", "a", "b", "path", "tool"] as const;

const TOOLS = ["morph", "deform", "fit", "space"];
/** Of a link: what only the studio shows. */
const STUDIO = /(?:^|&)(?:curve-a=|directed-a=|at=|locus=(?!morph)|tool=(?!morph))/;
const MOST_MAPS = 64;

/** What can be shown. What means nothing is left out and told; it throws where nothing is left to be shown. */
export function wishOf(attribute: Read): Wish {
  const troubles: WishError[] = [];
  /** Null where there is nothing that can be understood. */
  const understood = <T>(name: string, read: (text: string) => T): T | null => {
    const text = attribute(name)?.trim() ?? "";
    // Frameworks write an empty string for what is not there.
    if (text === "") return null;
    try {
      return read(text);
    } catch (problem) {
      if (!(problem instanceof WishError)) throw problem;
      troubles.push(problem);
      return null;
    }
  };
  const link = understood("src", fragmentOf);
  const a = understood("a", (text) => shapeWord("a", text));
  const b = understood("b", (text) => shapeWord("b", text));
  const path = understood("path", pathWord);
  const tool = understood("tool", toolWord);
  if (link === null && a === null)
    throw (
      troubles[0] ??
      new WishError("src", "Give src, a link of Frond, or a, the name of a shape such as fern.")
    );
  const start = link ?? "";
  if (/^(?:figures|learn)\//.test(start)) return { fragment: start, where: "figure", troubles };
  const words = new Map(start.split("&").flatMap((word) => (word === "" ? [] : [pairOf(word)])));
  if (a !== null) set(words, "a", a);
  // One shape alone is what it is at every moment.
  if (b !== null) set(words, "b", b);
  else if (link === null && a !== null) set(words, "b", a);
  if (path !== null) words.set("path", path);
  if (tool !== null) words.set("tool", tool);
  const fragment = [...words].map(([key, value]) => `${key}=${value}`).join("&");
  const here = !isOn(attribute("locus")) && !isOn(attribute("panel")) && !STUDIO.test(fragment);
  return { fragment, where: here ? "here" : "studio", troubles };
}

function toolWord(tool: string): string {
  if (!TOOLS.includes(tool)) throw new WishError("tool", `tool is one of ${TOOLS.join(", ")}.`);
  return tool;
}

function pairOf(word: string): [string, string] {
  const at = word.indexOf("=");
  return at < 0 ? [word, ""] : [word.slice(0, at), word.slice(at + 1)];
}

/** A shape that is named anew has no name of the link's any more. */
function set(words: Map<string, string>, key: string, value: string): void {
  words.set(key, value);
  words.delete(`${key}-name`);
}

function fragmentOf(src: string): string {
  const hash = src.indexOf("#");
  if (hash >= 0) return src.slice(hash + 1);
  if (/^[\w-]+=|^(?:figures|learn)\//.test(src)) return src;
  throw new WishError("src", "src is a link of Frond, with its #, or what stands behind the #.");
}

/** The name of a shape of the gallery, or its maps as JSON. */
function shapeWord(name: string, text: string): string {
  if (/^[a-z][a-z0-9-]*$/.test(text)) return text;
  const rows = rowsOf(text);
  if (!rows || rows.length === 0 || rows.length > MOST_MAPS)
    throw new WishError(
      name,
      `${name} is the name of a shape such as fern, or maps: [[a, b, c, d, e, f], ..], at most ${MOST_MAPS}.`,
    );
  return `maps:${rows.map((row) => row.join(",")).join(";")}`;
}

/** Rows of six, whichever way maps are written; null where they are none. */
function rowsOf(text: string): number[][] | null {
  let read: unknown;
  try {
    read = JSON.parse(text);
  } catch {
    return null;
  }
  const list = Array.isArray(read) ? read : (read as { maps?: unknown } | null)?.maps;
  if (!Array.isArray(list)) return null;
  // All numbers one after the other.
  if (areNumbers(list))
    return list.length % 6 === 0
      ? Array.from({ length: list.length / 6 }, (_, i) => list.slice(6 * i, 6 * i + 6))
      : null;
  const rows = list.map(rowOf);
  return rows.every((row) => row !== null) ? rows : null;
}

/** A map as its row [a, b, c, d, e, f], or as its matrix [[a, b, e], [c, d, f]], with or without [0, 0, 1] below. */
function rowOf(map: unknown): number[] | null {
  if (!Array.isArray(map)) return null;
  if (areNumbers(map)) return map.length === 6 ? map : null;
  const [first, second, third] = map;
  const whole = third === undefined || (Array.isArray(third) && third.join() === "0,0,1");
  const isLine = (line: unknown): line is number[] =>
    Array.isArray(line) && line.length === 3 && areNumbers(line);
  if (map.length > 3 || !whole || !isLine(first) || !isLine(second)) return null;
  const [a = 0, b = 0, e = 0] = first;
  const [c = 0, d = 0, f = 0] = second;
  return [a, b, c, d, e, f];
}

const areNumbers = (list: unknown[]): list is number[] => list.every(Number.isFinite);

/** `auto`, `straight`, or points between the ends: `0.1,0.8; 0.4,1.2`. */
function pathWord(plain: string): string {
  if (plain === "auto" || plain === "straight") return plain;
  const points = plain.split(";").map((point) =>
    point
      .trim()
      .split(/[\s,]+/)
      .map(Number),
  );
  const isPoint = (point: number[]) => [2, 3].includes(point.length) && point.every(Number.isFinite);
  if (!points.every(isPoint))
    throw new WishError("path", "path is auto, straight, or points between the ends: 0.1,0.8; 0.4,1.2.");
  return `drawn:${points.map((point) => point.join(",")).join(";")}`;
}

/** A moment from 0 to 1; null where there is none. */
export function momentOf(text: string | null): number | null {
  if (text === null || text.trim() === "") return null;
  const t = Number(text);
  if (!Number.isFinite(t)) throw new WishError("t", "t is a number from 0 to 1.");
  return Math.min(1, Math.max(0, t));
}

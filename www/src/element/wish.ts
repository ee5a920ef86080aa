/** What the attributes of a `<frond-view>` ask for, in words where it cannot be had. */

export interface Wish {
  /** The document: what stands behind the # of a link. */
  fragment: string;
  /** Drawn here, shown by the studio in a frame, or a page of its figures. */
  where: "here" | "studio" | "figure";
}

/** What is told to whoever wrote the page. */
export class WishError extends Error {
  readonly code = "attribute";
}

const TOOLS = ["morph", "deform", "fit", "space"];
/** Of a link: what only the studio shows. */
const STUDIO = /(?:^|&)(?:curve-a=|directed-a=|at=|locus=(?!morph)|tool=(?!morph))/;
const MOST_MAPS = 64;

/** Reads attributes by name; null stands for one that is not there. */
export function wishOf(attribute: (name: string) => string | null): Wish {
  const src = attribute("src")?.trim() ?? null;
  const [a, b] = [attribute("a"), attribute("b")];
  if (src === null && a === null)
    throw new WishError("Give src, a link of Frond, or a, the name of a shape such as fern.");
  const start = src === null ? "" : fragmentOf(src);
  if (/^(?:figures|learn)\//.test(start)) return { fragment: start, where: "figure" };
  const words = new Map(start.split("&").flatMap((word) => (word === "" ? [] : [pairOf(word)])));
  if (a !== null) set(words, "a", shapeWord("a", a));
  // One shape alone is what it is at every moment.
  if (b !== null || src === null) set(words, "b", shapeWord("b", b ?? a ?? ""));
  const path = attribute("path");
  if (path !== null) words.set("path", pathWord(path));
  const tool = attribute("tool");
  if (tool !== null) {
    if (!TOOLS.includes(tool)) throw new WishError(`tool is one of ${TOOLS.join(", ")}.`);
    words.set("tool", tool);
  }
  const fragment = [...words].map(([key, value]) => `${key}=${value}`).join("&");
  const here = attribute("locus") === null && attribute("panel") === null && !STUDIO.test(fragment);
  return { fragment, where: here ? "here" : "studio" };
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
  throw new WishError("src is a link of Frond, with its #, or what stands behind the #.");
}

/** The name of a shape of the gallery, or its maps as JSON. */
function shapeWord(name: string, text: string): string {
  const plain = text.trim();
  if (/^[a-z][a-z0-9-]*$/.test(plain)) return plain;
  const wrong = new WishError(
    `${name} is the name of a shape such as fern, or maps as JSON: [[a, b, c, d, e, f], ..], at most ${MOST_MAPS}.`,
  );
  let read: unknown;
  try {
    read = JSON.parse(plain);
  } catch {
    throw wrong;
  }
  const rows = Array.isArray(read) ? read : (read as { maps?: unknown } | null)?.maps;
  if (!Array.isArray(rows) || rows.length === 0 || rows.length > MOST_MAPS) throw wrong;
  const isRow = (row: unknown) => Array.isArray(row) && row.length === 6 && row.every(Number.isFinite);
  if (!rows.every(isRow)) throw wrong;
  return `maps:${rows.map((row: number[]) => row.join(",")).join(";")}`;
}

/** `auto`, `straight`, or points between the ends: `0.1,0.8; 0.4,1.2`. */
function pathWord(text: string): string {
  const plain = text.trim();
  if (plain === "auto" || plain === "straight") return plain;
  const points = plain.split(";").map((point) =>
    point
      .trim()
      .split(/[\s,]+/)
      .map(Number),
  );
  const isPoint = (point: number[]) => [2, 3].includes(point.length) && point.every(Number.isFinite);
  if (plain === "" || !points.every(isPoint))
    throw new WishError("path is auto, straight, or points between the ends: 0.1,0.8; 0.4,1.2.");
  return `drawn:${points.map((point) => point.join(",")).join(";")}`;
}

/** A moment from 0 to 1; null where there is none. */
export function momentOf(text: string | null): number | null {
  if (text === null || text.trim() === "") return null;
  const t = Number(text);
  if (!Number.isFinite(t)) throw new WishError("t is a number from 0 to 1.");
  return Math.min(1, Math.max(0, t));
}

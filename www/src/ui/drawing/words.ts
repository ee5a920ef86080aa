/** Words that a browser has laid out, as text of a drawing. Pure, for the tests. */
import { escaped, rounded, tag } from "../files/svg";
import { type Attributes, unlike } from "./attributes";

/** One character where it stands; a space that the browser left out has no width. */
export interface Glyph {
  text: string;
  left: number;
  top: number;
  width: number;
}

export type Align = "start" | "middle" | "end";

/** As style sheets say it. */
export function alignOf(value: string): Align {
  if (/center$/.test(value)) return "middle";
  return /^(right|end|-webkit-right)$/.test(value) ? "end" : "start";
}

/** Neighbouring words on one line that look alike. */
export interface Run {
  text: string;
  x: number;
  /** The line on which they stand. */
  y: number;
  width: number;
  look: Attributes;
  /** Of the letters, in pixels. */
  size: number;
  /** Which of their edges stays where it is in another font. */
  align: Align;
  /** In degrees; words that run down the page. */
  turn?: number;
}

/** The lines that a text was broken into, spaces as they are seen. */
export function linesOf(
  glyphs: Iterable<Glyph>,
): { text: string; left: number; top: number; width: number }[] {
  const lines: { text: string; left: number; top: number; width: number }[] = [];
  for (const { text, left, top, width } of glyphs) {
    const space = /^\s+$/.test(text) && text !== "\u00a0";
    if (space && width === 0) continue;
    const last = lines.at(-1);
    // What has no width is put on the letter before it, wherever it says it is.
    if (last && (width === 0 || Math.abs(last.top - top) < 2)) {
      last.text += space ? " " : text;
      last.width = Math.max(last.width, left + width - last.left);
    } else lines.push({ text: space ? " " : text, left, top, width });
  }
  return lines;
}

/** A gap of so many letters and more is one between columns, each of which keeps its place. */
const COLUMN = 0.9;
/** And one of fewer is none. */
const NONE = 0.12;
/** What is raised or lowered by less than so many letters belongs to the line. */
const RAISED = 0.7;

/** Runs as texts: those that stand beside each other are one text, with a space where the page shows one. */
export function textsOf(runs: readonly Run[]): string[] {
  const texts: Run[][] = [];
  for (const run of runs) {
    const line = texts.at(-1);
    const before = line?.at(-1);
    const blank = run.text.trim() === "";
    if (!line || !before || !continues(before, run)) {
      if (!blank) texts.push([{ ...run, text: run.text.replace(/^\s+/, "") }]);
      continue;
    }
    const gap = run.x - before.x - before.width;
    const spaced = blank || gap > NONE * run.size;
    if (spaced && !/\s$/.test(before.text)) before.text += " ";
    if (blank) before.width = run.x + run.width - before.x;
    else line.push({ ...run });
  }
  return texts.map(textOf);
}

function continues(before: Run, run: Run): boolean {
  if (before.turn !== run.turn || run.turn !== undefined) return false;
  const size = Math.max(before.size, run.size);
  const gap = run.x - before.x - before.width;
  return gap > -0.5 * size && gap < COLUMN * size && Math.abs(run.y - before.y) < RAISED * size;
}

/** Words follow each other as they do on the page, however wide they are in the font of whoever opens the file. */
function textOf(line: readonly Run[]): string {
  const [first, last] = [line[0], line.at(-1)];
  if (!first || !last) return "";
  const [left, right] = [first.x, last.x + last.width];
  const x = { start: left, middle: (left + right) / 2, end: right }[first.align];
  const place = { x: rounded(x), y: rounded(first.y) };
  const turned = first.turn === undefined ? {} : { transform: `rotate(${first.turn} ${place.x} ${place.y})` };
  const anchor = first.align === "start" || first.turn !== undefined ? {} : { "text-anchor": first.align };
  let above = first.y;
  const words = line.map(({ text, y, look }, i) => {
    const bare = escaped(i === line.length - 1 ? text.replace(/\s+$/, "") : text);
    if (i === 0) return bare;
    const dy = rounded(y - above);
    above = y;
    const other = unlike(look, first.look);
    const marks = { dy: dy === 0 ? undefined : dy, ...other };
    return Object.values(marks).every((value) => value === undefined) ? bare : tag("tspan", marks, bare);
  });
  // No line breaks between them: these would be spaces.
  return tag("text", { ...place, ...anchor, ...turned, ...first.look, ...KEPT_SPACES }, words.join(""));
}

/** Some programs drop a space before or behind a part of a text otherwise. */
const KEPT_SPACES = { "xml:space": "preserve" };

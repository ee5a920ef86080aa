/**
 * Whether lines of numbers are maps or points: numbers of a row are counted as `crate/exchange/src/read/table.rs` reads
 * them, without the labels before and the words behind.
 */

/** So many numbers has a map in a row: of the plane or of space, with a weight and a number of its own. */
const WIDTHS = [6, 7, 8, 12, 13, 14];
/** Fewer points make neither an outline nor a series. */
const FEWEST_POINTS = 3;

/** Of a longer line the beginning is looked at: it has more numbers than any map. */
const LONGEST_LINE = 4000;

/** Hyphens, dashes, and the dash of Windows in a text that was taken for Latin-1. */
const MINUS = /[\u0096\u2010-\u2014\u2212\ufe63\uff0d]/g;
const PLAIN = /^[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?$/i;
/** Fractions, roots and other formulas of numbers alone. */
const FORMULA = /^(?:[-+*/().\d√π½¼¾°^]|sqrt|cbrt|atan|sin|cos|tan|exp|abs|ln|pi)+$/i;
/** Formulas of x and y. */
const OF_PLACES = /^(?:[-+*/().\d\s√π½¼¾°^]|sqrt|cbrt|atan|sin|cos|tan|exp|abs|ln|pi|[xy](?!\d))+$/i;
/** Rows that a program prints in one line, each in brackets. */
const BETWEEN_ROWS = /[\])}]\s*,\s*(?=[[({])|\\\\/;
const REMARK = /^\s*(?:[;%/]|#(?!\d+[\s:,;|.)]))/;
/** Tables of LaTeX. */
const TEX = /\\(?:begin\{|hline|frac|sqrt)/;

const X_NAME = /^(?:x\d*|bx|posx|xpos|xcoord|lon|long|lng|longitude|easting|east|abscissa|rechtswert)$/;
const Y_NAME = /^(?:y\d*|by|posy|ypos|ycoord|lat|latitude|northing|north|ordinate|hochwert)$/;

interface Told {
  kind: "maps" | "outline" | null;
  /** Whether there are as many rows of points as a file needs that somebody means as one. */
  enough: boolean;
}

/** Null where no line has numbers alone. */
export function kindOfTable(text: string): Told {
  if (TEX.test(text) || (text.includes("&") && text.includes("\\\\"))) return { kind: "maps", enough: true };
  let points = 0;
  let places = false;
  for (const line of text.split(/\r?\n|\r/)) {
    if (REMARK.test(line)) continue;
    for (const row of line.slice(0, LONGEST_LINE).replace(MINUS, "-").split(BETWEEN_ROWS)) {
      if (points === 0 && isEquation(row)) return { kind: "maps", enough: true };
      const words = wordsOf(row);
      const is = words.map(isNumber);
      const [first, last] = [is.indexOf(true), is.lastIndexOf(true)];
      const count = last - first + 1;
      const whole = first >= 0 && is.slice(first, last + 1).every(Boolean);
      const bare = whole && count === words.length;
      if (whole && points === 0 && !places && WIDTHS.includes(count)) return { kind: "maps", enough: true };
      if (bare || (whole && first === 1 && count > 1)) points++;
      else if (points === 0 && words.length > 1 && !whole) places = namesPlaces(words);
      if (points >= FEWEST_POINTS) return { kind: "outline", enough: true };
    }
  }
  return { kind: points > 0 ? "outline" : null, enough: false };
}

/** The words of a row, without brackets, quotes and rules, and with decimal points. */
function wordsOf(row: string): string[] {
  const plain = row.replace(/[\u200b\u2060\ufeff]/g, "");
  const words = withPoints(plain).split(/[\s;|&[\]{}]+/);
  return words.map(bare).filter((word) => !/^[-=+:]*$/.test(word));
}

/** Commas become decimal points where blanks, semicolons or tabs part numbers; else they part them themselves. */
function withPoints(row: string): string {
  const words = row.split(/[\s;|&]+/).map((word) => word.replace(/^,+|,+$/g, ""));
  const decimal = words.some((word) => /\d,\d/.test(word)) && words.length > 1;
  if (!decimal || row.includes(".") || words.some((word) => /,.*,/.test(word))) return row.replace(/,/g, " ");
  return words.join(" ").replace(/,/g, ".");
}

function bare(word: string): string {
  let text = word.replace(/^["'“”]+|["'“”]+$/g, "");
  const count = (sign: string) => text.split(sign).length;
  while (text.startsWith("(") && count("(") > count(")")) text = text.slice(1);
  while (text.endsWith(")") && count(")") > count("(")) text = text.slice(0, -1);
  return text;
}

function isNumber(word: string): boolean {
  const text = word.replace(/%$/, "");
  return PLAIN.test(text) || (text.length > 1 && FORMULA.test(text) && /[\dπ½¼¾]|pi/i.test(text));
}

/** Whether a heading names x and y, also with units and with words beside. */
function namesPlaces(words: readonly string[]): boolean {
  const names = words.flatMap((word) => word.toLowerCase().split(/[^\p{L}\p{N}]+/u));
  return names.some((name) => X_NAME.test(name)) && names.some((name) => Y_NAME.test(name));
}

/** `f(x, y) = (0.85x + 0.04y, 1.6)`, or x' = .., y' = .. in one line. */
function isEquation(row: string): boolean {
  const line = row.trim().replace(/[.,;]+$/, "");
  if (!/[xy]/.test(line) || !/[,;]/.test(line)) return false;
  const right = (line.split("=").length === 2 ? (line.split("=")[1] ?? "") : line).trim();
  const inner = /^[([](.*)[)\]]$/.exec(right)?.[1] ?? right;
  const sides = inner.split(/[,;]/).map((side) => (side.split("=").at(-1) ?? "").trim());
  // Names of columns have no number, and a name before a number is a label.
  if (sides.length !== 2 || sides[0] === "x" || (sides[0] === "y" && inner === line)) return false;
  const all = sides.join();
  return sides.every((side) => OF_PLACES.test(side)) && /[xy]/i.test(all) && /\d/.test(all);
}

/** Numbers as people type them: decimals, fractions, roots, and formulas of these. */
import * as messages from "./messages";

export type Parsed = { ok: true; value: number } | { ok: false; message: string };

const HINT = messages.typeNumberSuchAs;
/** No formula for one number is longer; so neither is the way into its brackets. */
const LONGEST = 200;

const CONSTANTS: Readonly<Record<string, number>> = { pi: Math.PI, π: Math.PI, e: Math.E };
const FUNCTIONS: Readonly<Record<string, (x: number) => number>> = {
  sqrt: Math.sqrt,
  "√": Math.sqrt,
  cbrt: Math.cbrt,
  sin: Math.sin,
  cos: Math.cos,
  tan: Math.tan,
  asin: Math.asin,
  acos: Math.acos,
  atan: Math.atan,
  exp: Math.exp,
  ln: Math.log,
  log2: Math.log2,
  log10: Math.log10,
  abs: Math.abs,
};
/** What may stand behind a value. */
const DEGREES = Math.PI / 180;
const SUFFIXES: Readonly<Record<string, (x: number) => number>> = {
  "°": (x) => x * DEGREES,
  deg: (x) => x * DEGREES,
  rad: (x) => x,
  "²": (x) => x ** 2,
  "³": (x) => x ** 3,
};

/** Its thousands may be set apart by spaces. */
const NUMBER = /(?:\d{1,3}(?:[ \u00a0\u202f]\d{3})+(?!\d)|\d+)(?:\.\d*)?(?:e[+-]?\d+)?|\.\d+(?:e[+-]?\d+)?/;
/** A number, a word, or a sign. */
const TOKEN = new RegExp(`\\s*(?:(${NUMBER.source})|(log10|log2|[a-zπ]+)|([-+*/^()√°²³]))\\s*`, "iy");

class Refusal extends Error {}

/** What is left to be read of a formula. */
class Reader {
  readonly #tokens: readonly (number | string)[];
  #at = 0;

  constructor(text: string) {
    const tokens: (number | string)[] = [];
    TOKEN.lastIndex = 0;
    while (TOKEN.lastIndex < text.length) {
      const match = TOKEN.exec(text);
      if (match === null) throw new Refusal(HINT);
      const [, number, word, sign] = match;
      if (number !== undefined) tokens.push(Number(number.replace(/\s/g, "")));
      else tokens.push((word ?? sign ?? "").toLowerCase());
    }
    this.#tokens = tokens;
  }

  get next(): number | string | undefined {
    return this.#tokens[this.#at];
  }

  take(): number | string | undefined {
    return this.#tokens[this.#at++];
  }

  /** Takes a sign if it comes next. */
  has(...signs: readonly string[]): string | undefined {
    const { next } = this;
    if (typeof next !== "string" || !signs.includes(next)) return undefined;
    this.#at++;
    return next;
  }
}

function sum(reader: Reader): number {
  let value = product(reader);
  for (let sign = reader.has("+", "-"); sign; sign = reader.has("+", "-"))
    value = sign === "+" ? value + product(reader) : value - product(reader);
  return value;
}

function product(reader: Reader): number {
  let value = signed(reader);
  for (;;) {
    if (reader.has("*")) value *= signed(reader);
    else if (reader.has("/")) value /= signed(reader);
    // 2√3, 2(1 + x): a product without a sign. Two numbers side by side are a slip.
    else if (typeof reader.next === "string" && startsValue(reader.next)) value *= power(reader);
    else return value;
  }
}

const startsValue = (token: string) =>
  token === "(" || Object.hasOwn(CONSTANTS, token) || Object.hasOwn(FUNCTIONS, token);

function signed(reader: Reader): number {
  const sign = reader.has("+", "-");
  return sign === "-" ? -power(reader) : power(reader);
}

function power(reader: Reader): number {
  const base = suffixed(reader);
  return reader.has("^") ? base ** signed(reader) : base;
}

function suffixed(reader: Reader): number {
  let value = single(reader);
  while (typeof reader.next === "string" && Object.hasOwn(SUFFIXES, reader.next))
    value = SUFFIXES[String(reader.take())]?.(value) ?? Number.NaN;
  return value;
}

function single(reader: Reader): number {
  const token = reader.take();
  if (typeof token === "number") return token;
  if (token === "(") {
    const value = sum(reader);
    if (!reader.has(")")) throw new Refusal(messages.bracketStillOpenEach);
    return value;
  }
  if (token === undefined) throw new Refusal(HINT);
  if (Object.hasOwn(CONSTANTS, token)) return CONSTANTS[token] ?? Number.NaN;
  // Of a root or a sine without brackets is what stands next, with its degrees or its square: cos 30°.
  if (Object.hasOwn(FUNCTIONS, token)) return FUNCTIONS[token]?.(suffixed(reader)) ?? Number.NaN;
  throw unexpected(token);
}

function unexpected(token: number | string): Refusal {
  if (token === ")") return new Refusal(messages.thereWithout);
  if (typeof token === "string" && /^[a-z]/.test(token) && !Object.hasOwn(SUFFIXES, token))
    return new Refusal(
      token === "log"
        ? messages.chooseBaseWriteLn
        : token === "i"
          ? messages.noComplexNumbers
          : messages.unknownInNumber(token),
    );
  return new Refusal(HINT);
}

/** Fractions that are one sign; with a whole number before them they are added to it. */
const FRACTION = /(\d*)\s*([¼½¾⅐-⅞])/g;
const fraction = (_: string, whole: string, sign: string) =>
  `(${whole === "" ? "" : `${whole}+`}${sign.normalize("NFKC").replace("⁄", "/")})`;

/** Words and signs that mean the same. */
function plain(input: string): string {
  const text = input
    .trim()
    .replace(/[−–]/g, "-")
    .replace(/\*\*/g, "^")
    .replace(/[×·⋅∙]/g, "*")
    .replace(/[÷:⁄∕]/g, "/")
    .replace(FRACTION, fraction);
  // Where there are both, the last of comma and point is the decimal one, and the others set thousands apart.
  if (/^-?\d{1,3}(?:,\d{3})+\.\d+$/.test(text)) return text.replaceAll(",", "");
  if (/^-?\d{1,3}(?:\.\d{3})+,\d+$/.test(text)) return text.replaceAll(".", "").replace(",", ".");
  // A single comma between digits is a decimal comma; anything else with commas is not a number.
  return /^[^,]*\d,\d[^,]*$/.test(text) ? text.replace(",", ".") : text;
}

/** The field says its unit already. An angle within a formula, as in 90 cos 60°, keeps its own. */
function withoutUnit(input: string, unit: string | undefined): string {
  const text = input.trim();
  // All of it may be told in another unit: 1/4 turn.
  const [, all, other = ""] = /^((?:[^a-z√°]|pi)+)(rad|turn)s?$/i.exec(text) ?? [];
  if (all !== undefined) {
    const isTurn = other.toLowerCase() === "turn";
    if (unit === "°") return isTurn ? `(${all})*360` : `(${all})/1°`;
    return isTurn ? `(${all})*2pi` : `(${all})`;
  }
  if (unit === undefined || unit === "") return text;
  if (unit === "°") return text.replace(/^([^a-z√°]*)(?:°|deg)$/i, "$1");
  return text.endsWith(unit) ? text.slice(0, -unit.length) : text;
}

/** In words that a link keeps: lower case, and no sign that is not ASCII. */
const ASCII: readonly (readonly [RegExp, string])[] = [
  [/\s+/g, ""],
  [/√/g, "sqrt"],
  [/π/g, "pi"],
  [/°/g, "deg"],
  [/²/g, "**2"],
  [/³/g, "**3"],
  [/\^/g, "**"],
  [/^(.*)%$/, "($1)/100"],
];

/** A formula that `parseNumber` reads, as the module for exact numbers and links take it; of an angle in degrees. */
export function formulaOf(input: string, unit?: string): string {
  const text = plain(withoutUnit(input, unit)).toLowerCase();
  return ASCII.reduce((written, [sign, word]) => written.replace(sign, word), text);
}

/**
 * Reads a number or a formula: `-.5`, `1/3`, `2√3/4`, `(1 + sqrt 5)/2`, `cos 30°`, `1e-3`, `0,25`, `50%`. Angles are
 * radians unless it says degrees or turns; in a field whose `unit` is degrees a bare number is degrees. A per cent sign
 * stands at the end, and is of all. The result is finite or it is a message that says what to type.
 */
export function parseNumber(input: string, unit?: string): Parsed {
  if (input.length > LONGEST) return { ok: false, message: messages.tooLong(HINT) };
  let text = plain(withoutUnit(input, unit));
  const percent = text.endsWith("%");
  if (percent) text = text.slice(0, -1);
  try {
    const reader = new Reader(text);
    const value = sum(reader) * (percent ? 0.01 : 1);
    if (reader.next !== undefined) throw unexpected(reader.next);
    if (!Number.isFinite(value))
      return {
        ok: false,
        message: messages.resultTooLargeDivides,
      };
    return { ok: true, value: value === 0 ? 0 : value };
  } catch (problem) {
    if (problem instanceof Refusal) return { ok: false, message: problem.message };
    throw problem;
  }
}

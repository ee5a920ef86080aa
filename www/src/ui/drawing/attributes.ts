/**
 * What a style sheet says of a part of a drawing, as plain attributes of SVG 1.1: no `style`, which a policy may
 * forbid. Pure, for the tests.
 */
import { BLACK } from "#style/colours";
import { rounded } from "../files/svg";

export type Attributes = Readonly<Record<string, string | number | undefined>>;
/** A property as the browser has worked it out. */
export type Style = (property: string) => string;

/** What a part looks like that says nothing of itself. */
const PAINTS: Readonly<Record<string, string>> = {
  "fill-opacity": "1",
  "fill-rule": "nonzero",
  "stroke-opacity": "1",
  "stroke-linecap": "butt",
  "stroke-linejoin": "miter",
  "stroke-miterlimit": "4",
  "paint-order": "normal",
  "shape-rendering": "auto",
  "marker-start": "none",
  "marker-mid": "none",
  "marker-end": "none",
  "clip-rule": "nonzero",
};
const OTHERS: Readonly<Record<string, string>> = {
  opacity: "1",
  "clip-path": "none",
  mask: "none",
  filter: "none",
};
const WORDS: Readonly<Record<string, string>> = {
  "font-style": "normal",
  "font-weight": "400",
  "letter-spacing": "normal",
  "text-anchor": "start",
  "dominant-baseline": "auto",
};
const LINES = /^(stroke|marker)-/;

/** Of lines, areas and words of a drawing; `scale`: pixels of the page for one of its units. */
export function paintOf(style: Style, scale: number): Attributes {
  const found: Record<string, string | number | undefined> = {};
  Object.assign(found, colour("fill", style("fill"), BLACK), colour("stroke", style("stroke"), "none"));
  const lined = found["stroke"] !== undefined;
  for (const [name, plain] of Object.entries(PAINTS)) {
    const value = local(style(name));
    // A colour that is seen through by itself is so once more by this.
    if (name in found) found[name] = rounded(Number(found[name]) * Number(value || 1));
    else if (value !== plain && value !== "" && (lined || !LINES.test(name) || name.startsWith("marker")))
      found[name] = value;
  }
  if (lined) {
    // Lines that stay as wide on any screen have a width of their own in a file.
    const unit = style("vector-effect") === "non-scaling-stroke" ? scale : 1;
    const width = (Number.parseFloat(style("stroke-width")) || 0) / unit;
    if (width !== 1) found["stroke-width"] = rounded(width);
    const dashes = numbersOf(style("stroke-dasharray")).map((dash) => rounded(dash / unit));
    if (dashes.length > 0) found["stroke-dasharray"] = dashes.join(" ");
    const offset = (Number.parseFloat(style("stroke-dashoffset")) || 0) / unit;
    if (dashes.length > 0 && offset !== 0) found["stroke-dashoffset"] = rounded(offset);
  }
  return found;
}

/** Of anything in a drawing, groups too. */
export function groupOf(style: Style): Attributes {
  const found: Record<string, string | undefined> = {};
  for (const [name, plain] of Object.entries(OTHERS)) {
    const value = local(style(name));
    if (value !== plain && value !== "") found[name] = value;
  }
  return found;
}

/** Of words, in a drawing or on the page. */
export function fontOf(style: Style): Attributes {
  const found: Record<string, string | number | undefined> = {
    "font-family": familyOf(style("font-family")),
    "font-size": rounded(Number.parseFloat(style("font-size")) || 0),
  };
  for (const [name, plain] of Object.entries(WORDS)) {
    const value = style(name);
    if (value !== plain && value !== "") found[name] = value.replace(/px$/, "");
  }
  const line = style("text-decoration-line");
  if (line !== "none" && line !== "") found["text-decoration"] = line;
  return found;
}

/** Fonts of one system are not those of another: a kind that all have. */
function familyOf(value: string): string {
  const last = value.split(",").at(-1)?.trim() ?? "";
  return /^(serif|monospace)$/.test(last) ? last : "sans-serif";
}

/** Words of the page: they have one colour. */
export function wordsLook(style: Style): Attributes {
  const { "text-anchor": _anchor, "dominant-baseline": _baseline, ...font } = fontOf(style);
  return { ...font, ...colour("fill", style("color"), "") };
}

/** A colour, and how far it is seen through; nothing where it is what a drawing has by itself. */
export function colour(name: "fill" | "stroke" | "stop-color", value: string, plain: string): Attributes {
  const opacity = name === "stop-color" ? "stop-opacity" : `${name}-opacity`;
  const parsed = parsedColour(value);
  if (!parsed) {
    // None, or a pattern.
    const paint = local(value);
    return paint === plain || paint === "" ? {} : { [name]: paint };
  }
  const { hex, alpha } = parsed;
  if (alpha === 0) return plain === "none" ? {} : { [name]: "none" };
  return { ...(hex === plain ? {} : { [name]: hex }), ...(alpha < 1 ? { [opacity]: rounded(alpha) } : {}) };
}

/** As browsers write colours that they have worked out; null for what is none. */
export function parsedColour(value: string): { hex: string; alpha: number } | null {
  const [, kind, inner = ""] = /^(rgba?|color)\(([^()]*)\)$/.exec(value.trim()) ?? [];
  if (kind === undefined) return null;
  const most = kind === "color" ? 1 : 255;
  if (kind === "color" && !inner.startsWith("srgb ")) return null;
  const parts = inner
    .replace(/^srgb /, "")
    .split(/[\s,/]+/)
    .map((part) => (part.endsWith("%") ? Number.parseFloat(part) / 100 : Number(part)));
  const [r = 0, g = 0, b = 0, alpha = 1] = parts;
  const hex = [r, g, b].map((x) =>
    Math.round((255 * Math.min(most, Math.max(0, x))) / most)
      .toString(16)
      .padStart(2, "0"),
  );
  return [r, g, b, alpha].every(Number.isFinite) ? { hex: `#${hex.join("")}`, alpha } : null;
}

/** What differs from what is around it; what it has lost is said, too. */
export function unlike(own: Attributes, around: Attributes): Attributes {
  const found: Record<string, string | number | undefined> = {};
  for (const [name, value] of Object.entries(own)) if (around[name] !== value) found[name] = value;
  for (const name of Object.keys(around)) if (own[name] === undefined) found[name] = LOST[name];
  return found;
}

const LOST: Readonly<Record<string, string | undefined>> = {
  "font-weight": "400",
  "font-style": "normal",
  "letter-spacing": "normal",
  "fill-opacity": "1",
  fill: BLACK,
};

/** Other parts of the page are other parts of the file. */
const local = (value: string): string => value.replace(/url\("?[^"#)]*(#[^")]+)"?\)/g, "url($1)").trim();

const numbersOf = (list: string): number[] =>
  list === "none"
    ? []
    : list
        .split(/[\s,]+/)
        .map(Number.parseFloat)
        .filter(Number.isFinite);

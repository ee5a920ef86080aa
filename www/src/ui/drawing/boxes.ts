/** Grounds and borders of parts of the page, as rectangles and lines. */
import { rounded, tag } from "../files/svg";
import { type Attributes, colour, parsedColour, type Style } from "./attributes";

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

const SIDES = ["top", "right", "bottom", "left"] as const;
const pixels = (value: string): number => Number.parseFloat(value) || 0;

/** What is seen of a box besides what is in it. `id`: for what only it refers to. */
export function boxOf(style: Style, box: Box, id: () => string): string[] {
  const rx = radiusOf(style, box);
  return [
    ...ringsOf(style, box, rx),
    ...ground(style, box, rx),
    ...gradient(style("background-image"), box, rx, id),
    ...borders(style, box, rx),
  ];
}

export function radiusOf(style: Style, { width, height }: Box): number {
  const value = style("border-top-left-radius").split(" ")[0] ?? "";
  const most = Math.min(width, height) / 2;
  return Math.min(
    most,
    value.endsWith("%") ? (pixels(value) * Math.min(width, height)) / 100 : pixels(value),
  );
}

function rectangle({ x, y, width, height }: Box, rx: number, attributes: Attributes): string {
  const round = rx > 0 ? { rx: rounded(rx) } : {};
  return tag("rect", {
    ...{ x: rounded(x), y: rounded(y), width: rounded(width), height: rounded(height) },
    ...round,
    ...attributes,
  });
}

function ground(style: Style, box: Box, rx: number): string[] {
  const fill = colour("fill", style("background-color"), "");
  return fill["fill"] === "none" || fill["fill"] === undefined ? [] : [rectangle(box, rx, fill)];
}

function inset({ x, y, width, height }: Box, by: number): Box {
  return { x: x + by, y: y + by, width: Math.max(0, width - 2 * by), height: Math.max(0, height - 2 * by) };
}

function borders(style: Style, box: Box, rx: number): string[] {
  const sides = SIDES.map((side) => {
    const kind = style(`border-${side}-style`);
    const width = kind === "none" || kind === "hidden" ? 0 : pixels(style(`border-${side}-width`));
    const stroke = colour("stroke", style(`border-${side}-color`), "none");
    const dashes =
      kind === "dashed" ? `${3 * width} ${2 * width}` : kind === "dotted" ? `${width}` : undefined;
    const line = { ...stroke, "stroke-width": width, "stroke-dasharray": dashes };
    return { width: stroke["stroke"] === undefined ? 0 : width, line };
  });
  const [first] = sides;
  if (first && first.width > 0 && new Set(sides.map(({ line }) => JSON.stringify(line))).size === 1) {
    const half = first.width / 2;
    return [rectangle(inset(box, half), Math.max(0, rx - half), { fill: "none", ...first.line })];
  }
  const [x0, y0, x1, y1] = [box.x, box.y, box.x + box.width, box.y + box.height];
  return sides.flatMap(({ width, line }, i) => {
    if (width === 0) return [];
    const half = width / 2;
    const ends = [
      [x0, y0 + half, x1, y0 + half],
      [x1 - half, y0, x1 - half, y1],
      [x0, y1 - half, x1, y1 - half],
      [x0 + half, y0, x0 + half, y1],
    ][i];
    const [a = 0, b = 0, c = 0, d = 0] = (ends ?? []).map(rounded);
    return [tag("path", { d: `M${a} ${b}L${c} ${d}`, fill: "none", ...line })];
  });
}

/** Shadows that are rings: not moved and not blurred. */
function ringsOf(style: Style, box: Box, rx: number): string[] {
  const shadows = style("box-shadow").match(/(rgba?|color)\([^()]*\)[^(]*?(?=, (?:rgba?|color)\(|$)/g) ?? [];
  return shadows.flatMap((shadow) => {
    const [, paint = "", lengths = ""] = /^([^)]*\))(.*)$/.exec(shadow.trim()) ?? [];
    const [x, y, blur, spread = 0] = lengths.match(/-?[\d.]+(?=px)/g)?.map(Number) ?? [];
    const parsed = parsedColour(paint);
    if (x !== 0 || y !== 0 || blur !== 0 || spread <= 0 || !parsed || parsed.alpha === 0) return [];
    // One within begins at the inner edge of the border.
    const by = lengths.includes("inset") ? pixels(style("border-top-width")) + spread / 2 : -spread / 2;
    const line = { ...colour("stroke", paint, "none"), "stroke-width": spread };
    return [rectangle(inset(box, by), Math.max(0, rx - by), { fill: "none", ...line })];
  });
}

/** From left to right, or in slanting stripes: no other is on the pages. */
function gradient(image: string, box: Box, rx: number, id: () => string): string[] {
  const [, repeating, direction = "", list = ""] =
    /^(repeating-)?linear-gradient\((?:(to [a-z]+|-?[\d.]+deg), )?(.*)\)$/.exec(image) ?? [];
  const stops = [...list.matchAll(/((?:rgba?|color)\([^()]*\))((?: [\d.]+(?:px|%))*)/g)].map(
    ([, paint = "", places = ""]) => ({ paint, places: places.trim().split(" ").map(pixels) }),
  );
  const [first, second, third] = stops;
  if (!first || !second) return [];
  const name = id();
  const fill = { fill: `url(#${name})` };
  if (repeating !== undefined && third) {
    const length = stops.at(-1)?.places.at(-1) ?? 0;
    const wide = second.places[0] ?? 0;
    if (length <= 0 || wide <= 0) return [];
    // A gradient of 90 degrees runs to the right, and a pattern as it stands does the same.
    const turn = pixels(direction) - 90;
    const units = { width: length, height: length, patternUnits: "userSpaceOnUse" };
    const stripe = tag("rect", { width: wide, height: length, ...colour("fill", first.paint, "") });
    return [
      tag("pattern", { id: name, ...units, patternTransform: `rotate(${turn})` }, stripe),
      rectangle(box, rx, fill),
    ];
  }
  if (direction !== "to right") return [];
  const parts = stops.map(({ paint }, i) =>
    tag("stop", { offset: rounded(i / (stops.length - 1)), ...colour("stop-color", paint, "") }),
  );
  return [tag("linearGradient", { id: name }, ...parts), rectangle(box, rx, fill)];
}

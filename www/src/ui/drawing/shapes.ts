/** A drawing that stands on the page, as the same drawing in a file. */
import { escaped, rounded, tag } from "../files/svg";
import { type Attributes, colour, fontOf, groupOf, paintOf, type Style, unlike } from "./attributes";

/** Kept as they are written: what is where. */
const KEPT = new Set(
  (
    "id x y x1 y1 x2 y2 cx cy r rx ry fx fy dx dy width height points d viewBox preserveAspectRatio offset " +
    "patternUnits patternContentUnits patternTransform gradientUnits gradientTransform spreadMethod " +
    "markerWidth markerHeight markerUnits refX refY orient clipPathUnits maskUnits maskContentUnits " +
    "pathLength rotate textLength lengthAdjust"
  ).split(" "),
);
/** Where a style sheet may say it, and then counts. */
const PLACED: Readonly<Record<string, readonly string[]>> = {
  circle: ["cx", "cy", "r"],
  ellipse: ["cx", "cy", "rx", "ry"],
  rect: ["x", "y", "width", "height", "rx", "ry"],
};
const PAINTED = new Set(["path", "line", "polyline", "polygon", "circle", "ellipse", "rect"]);
const WORDS = new Set(["text", "tspan"]);
const GROUPS = new Set([
  "g",
  "defs",
  "marker",
  "pattern",
  "clipPath",
  "mask",
  "linearGradient",
  "radialGradient",
]);

interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** A whole drawing, in its place. */
export function drawingOf(svg: SVGSVGElement, { x, y, width, height }: Box): string {
  const style = styleOf(svg);
  const label = svg.getAttribute("aria-label");
  return tag(
    "svg",
    {
      x: rounded(x),
      y: rounded(y),
      width: rounded(width),
      height: rounded(height),
      viewBox: svg.getAttribute("viewBox") ?? undefined,
      preserveAspectRatio: svg.getAttribute("preserveAspectRatio") ?? undefined,
      overflow: style("overflow-x") === "visible" ? "visible" : undefined,
      ...groupOf(style),
    },
    ...(label ? [tag("title", {}, escaped(label))] : []),
    ...partsOf(svg),
  );
}

function partsOf(parent: Element): string[] {
  return [...parent.children].flatMap((child) => (child instanceof SVGElement ? [partOf(child)] : []));
}

function partOf(element: SVGElement): string {
  const name = element.localName;
  const style = styleOf(element);
  if (style("display") === "none") return "";
  const own = { ...keptOf(element), ...transformOf(element, style), ...groupOf(style) };
  if (name === "svg") return tag("svg", own, ...partsOf(element));
  if (GROUPS.has(name)) {
    const inner = partsOf(element);
    return inner.length === 0 && name === "g" ? "" : tag(name, own, ...inner);
  }
  if (name === "stop") {
    const stop = colour("stop-color", style("stop-color"), "");
    return tag("stop", { ...own, ...stop });
  }
  if (style("visibility") !== "visible") return "";
  if (WORDS.has(name)) return tag(name, { ...own, ...lettersOf(element, style) }, lettering(element));
  if (!PAINTED.has(name)) return "";
  return tag(name, { ...own, ...placed(element, style), ...paintOf(style, scaleOf(element)) });
}

/** Of words: all that they look like, or what is other than around them. */
function lettersOf(element: SVGElement, style: Style): Attributes {
  const look = { ...fontOf(style), ...paintOf(style, scaleOf(element)) };
  const { parentElement: around } = element;
  if (!(around instanceof SVGElement) || !WORDS.has(around.localName)) return look;
  const outer = styleOf(around);
  return unlike(look, { ...fontOf(outer), ...paintOf(outer, scaleOf(around)) });
}

/** Words and the parts among them, in one line: a break would be a space. */
function lettering(element: Element): string {
  return [...element.childNodes]
    .map((child) =>
      child instanceof SVGElement
        ? partOf(child)
        : child instanceof Text
          ? escaped(child.data.replace(/\s+/g, " "))
          : "",
    )
    .join("");
}

function keptOf(element: Element): Attributes {
  return Object.fromEntries(
    [...element.attributes].flatMap(({ name, value }) => (KEPT.has(name) ? [[name, value]] : [])),
  );
}

function placed(element: Element, style: Style): Attributes {
  const found: Record<string, string> = {};
  for (const name of PLACED[element.localName] ?? []) {
    const value = style(name);
    if (value !== "" && value !== "auto") found[name] = value.replace(/px$/, "");
  }
  return found;
}

/** A style sheet turns about a point of its own; an attribute about the origin. */
function transformOf(element: Element, style: Style): Attributes {
  const value = style("transform");
  if (value === "none" || value === "" || !value.startsWith("matrix(")) return {};
  const m = new DOMMatrix(value);
  if (!element.hasAttribute("transform")) {
    const [x = 0, y = 0] = style("transform-origin").split(" ").map(Number.parseFloat);
    const about = new DOMMatrix().translate(x, y).multiply(m).translate(-x, -y);
    return { transform: matrixWords(about) };
  }
  return { transform: matrixWords(m) };
}

const fine = (x: number): number => Math.round(1e6 * x) / 1e6;
function matrixWords({ a, b, c, d, e, f }: DOMMatrix): string {
  const plain = a === 1 && b === 0 && c === 0 && d === 1;
  return plain ? `translate(${fine(e)} ${fine(f)})` : `matrix(${[a, b, c, d, e, f].map(fine).join(" ")})`;
}

/** Pixels of the page for a unit at a part of a drawing. */
function scaleOf(element: SVGElement): number {
  const m = element instanceof SVGGraphicsElement ? element.getScreenCTM() : null;
  const scale = m ? Math.sqrt(Math.abs(m.a * m.d - m.b * m.c)) : 1;
  return scale > 0 ? scale : 1;
}

export function styleOf(element: Element, pseudo?: string): Style {
  const style = getComputedStyle(element, pseudo);
  return (property) => style.getPropertyValue(property);
}

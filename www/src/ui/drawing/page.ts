/**
 * A part of the page as a drawing of its own: what is drawn stays lines and areas, pictures go in as they are, words
 * stand where the browser has laid them out, and what only a hand could use is left out.
 */
import { escaped, rounded, svgFile, tag } from "../files/svg";
import * as messages from "../messages";
import { wordsLook } from "./attributes";
import { type Box, boxOf, radiusOf } from "./boxes";
import { drawingOf, styleOf } from "./shapes";
import { alignOf, type Glyph, linesOf, type Run, textsOf } from "./words";

export interface Drawing {
  text: string;
  /** In pixels of the page. */
  width: number;
  height: number;
}

interface Asked {
  /** Below each other, or beside, as they stand on the page. */
  parts: readonly Element[];
  title: string;
  about: string;
  /** A colour; null: what is behind it is seen through it. */
  ground: string | null;
  /** What is left out, besides what is pressed or typed in. */
  without: string;
}

/** Around all, in pixels. */
const MARGIN = 16;
/** What waits for a hand. Pictures that can be pressed are pictures all the same. */
const CONTROLS =
  "button, input, select, textarea, progress, fieldset, dialog, [role=button], [role=slider], .slider, .switch-track, " +
  // In a list a label says what a colour is.
  "label:not(li label)";
const PICTURES = "canvas, img, svg:not([class~=icon])";

/** The whole file. */
export function drawingOfPage({ parts, title, about, ground, without }: Asked): Drawing {
  const restore = prepare(parts, without);
  try {
    const walk = new Walk();
    for (const part of parts) walk.within(part);
    const { box } = walk;
    if (!Number.isFinite(box.x0)) throw new Error(messages.thereNothingToDraw);
    const [x, y] = [box.x0 - MARGIN, box.y0 - MARGIN];
    const [width, height] = [box.x1 - x + MARGIN, box.y1 - y + MARGIN];
    const behind = ground === null ? [] : [tag("rect", { x, y, width, height, fill: ground })];
    const text = svgFile(
      {
        box: [x, y, width, height],
        title,
        about: messages.madeBy(about).trim(),
        style: { "xmlns:xlink": "http://www.w3.org/1999/xlink" },
      },
      ...behind,
      ...walk.texts(),
    );
    return { text, width, height };
  } finally {
    restore();
  }
}

/** Has the page lay itself out as the file is to be; nobody sees it, as it is undone before the browser draws. */
function prepare(parts: readonly Element[], without: string): () => void {
  const undo: (() => void)[] = [];
  const set = (element: HTMLElement, property: string, value: string) => {
    const { style } = element;
    const before = [style.getPropertyValue(property), style.getPropertyPriority(property)] as const;
    style.setProperty(property, value, "important");
    undo.push(() => style.setProperty(property, ...before));
  };
  for (let outer = parts[0]?.parentElement; outer; outer = outer.parentElement) {
    const [at, { scrollTop, scrollLeft }] = [outer, outer];
    undo.push(() => at.scrollTo({ top: scrollTop, left: scrollLeft, behavior: "instant" }));
  }
  for (const part of parts) {
    const gone = new Set<Element>();
    for (const element of part.querySelectorAll<HTMLElement>(`${CONTROLS}, ${without}`)) {
      const asked = without !== "" && element.matches(without);
      if (!asked && (element.matches(`:has(${PICTURES})`) || isMark(element))) continue;
      set(element, "display", "none");
      gone.add(element);
      // What was around nothing else would leave a gap.
      for (let around = element.parentElement; around && around !== part; around = around.parentElement) {
        if ([...around.childNodes].some((child) => !isGone(child, gone))) break;
        set(around, "display", "none");
        gone.add(around);
      }
    }
    for (const element of part.querySelectorAll<HTMLElement>("*")) {
      const { overflowX, overflowY } = getComputedStyle(element);
      if (![overflowX, overflowY].some((kind) => kind === "auto" || kind === "scroll")) continue;
      const { scrollTop, scrollLeft } = element;
      undo.push(() => element.scrollTo({ top: scrollTop, left: scrollLeft, behavior: "instant" }));
      set(element, "overflow", "visible");
    }
  }
  return () => {
    for (const one of undo.reverse()) one();
  };
}

function isGone(node: Node, gone: ReadonlySet<Element>): boolean {
  if (node instanceof Element) return gone.has(node) || isUnseen(node);
  return !(node instanceof Text) || node.data.trim() === "";
}

/** A handle on a picture: it has no words, and shows where something is. */
function isMark(element: HTMLElement): boolean {
  const { position } = getComputedStyle(element);
  return position === "absolute" && element.textContent?.trim() === "" && !element.matches("input, progress");
}

/** Said only to those who hear the page. */
function isUnseen(element: Element): boolean {
  return getComputedStyle(element).clipPath === "inset(50%)";
}

class Walk {
  private readonly parts: (string | Run)[] = [];
  private names = 0;
  readonly box = { x0: Infinity, y0: Infinity, x1: -Infinity, y1: -Infinity };

  /** What is in it; its own ground and border are those of the page. */
  within(element: Element): void {
    for (const child of element.childNodes) this.node(child);
  }

  /** All of it, in the order of the page. */
  texts(): string[] {
    const texts: string[] = [];
    let runs: Run[] = [];
    const flush = () => {
      texts.push(...textsOf(runs));
      runs = [];
    };
    for (const part of this.parts) {
      if (typeof part !== "string") runs.push(part);
      else {
        flush();
        texts.push(part);
      }
    }
    flush();
    return texts;
  }

  private node(node: Node): void {
    if (node instanceof Text) this.words(node);
    else if (node instanceof SVGSVGElement || node instanceof HTMLElement) this.element(node);
  }

  private element(element: HTMLElement | SVGSVGElement): void {
    const style = styleOf(element);
    if (style("display") === "none" || style("opacity") === "0" || isUnseen(element)) return;
    if (style("display") === "contents") {
      this.within(element);
      return;
    }
    const { x, y, width, height } = element.getBoundingClientRect();
    const box = { x, y, width, height };
    const opacity = style("opacity");
    const clips = /hidden|clip/.test(style("overflow-x")) && !(element instanceof SVGElement);
    const from = this.parts.length;
    const outer = { ...this.box };
    if (style("visibility") === "visible" && width > 0 && height > 0) this.own(element, box);
    if (!(element instanceof SVGElement) && !(element instanceof HTMLCanvasElement)) this.within(element);
    if (opacity === "1" && !clips) return;
    const inner = this.cut(from);
    if (inner.length === 0) return;
    if (clips) {
      Object.assign(this.box, outer);
      this.reach(box);
      const view = [x, y, width, height].map(rounded);
      const [left, top, wide, high] = view;
      const place = { x: left, y: top, width: wide, height: high, viewBox: view.join(" ") };
      this.parts.push(tag("svg", opacity === "1" ? place : { ...place, opacity }, ...inner));
    } else this.parts.push(tag("g", { opacity }, ...inner));
  }

  /** Takes back what was written since. */
  private cut(from: number): string[] {
    const before = this.parts.splice(0, from);
    const inner = this.texts();
    this.parts.splice(0, this.parts.length, ...before);
    return inner;
  }

  /** What an element is besides what is in it. */
  private own(element: HTMLElement | SVGSVGElement, box: Box): void {
    const style = styleOf(element);
    const id = () => `ground-${++this.names}`;
    this.put(boxOf(style, box, id), box);
    const inner = contentOf(style, box);
    if (element instanceof SVGSVGElement) this.put([drawingOf(element, inner)], box);
    if (element instanceof HTMLCanvasElement || element instanceof HTMLImageElement) {
      const image = this.picture(element, inner, radiusOf(style, box));
      if (image !== "") this.put([image], box);
    }
    for (const pseudo of ["::before", "::after"]) {
      const own = styleOf(element, pseudo);
      if (!/^["']["']$/.test(own("content")) || own("position") !== "absolute") continue;
      const [left = 0, top = 0, width = 0, height = 0] = ["left", "top", "width", "height"].map(
        (side) => Number.parseFloat(own(side)) || 0,
      );
      const edges =
        own("box-sizing") === "border-box" ? 0 : 2 * (Number.parseFloat(own("border-top-width")) || 0);
      const place = { x: box.x + left, y: box.y + top, width: width + edges, height: height + edges };
      this.put(boxOf(own, place, id), place);
    }
  }

  private put(texts: readonly string[], box: Box): void {
    const there = texts.filter((text) => text !== "");
    if (there.length === 0) return;
    this.parts.push(...there);
    this.reach(box);
  }

  private reach({ x, y, width, height }: Box): void {
    this.box.x0 = Math.min(this.box.x0, x);
    this.box.y0 = Math.min(this.box.y0, y);
    this.box.x1 = Math.max(this.box.x1, x + width);
    this.box.y1 = Math.max(this.box.y1, y + height);
  }

  private picture(
    element: HTMLCanvasElement | HTMLImageElement,
    { x, y, width, height }: Box,
    rx: number,
  ): string {
    const href = pngOf(element);
    if (href === null) return "";
    const style = styleOf(element);
    const fits = { contain: "xMidYMid meet", cover: "xMidYMid slice" }[style("object-fit")] ?? "none";
    const place = { x: rounded(x), y: rounded(y), width: rounded(width), height: rounded(height) };
    const rendering = style("image-rendering");
    const label = element.getAttribute("aria-label") ?? element.getAttribute("alt");
    const name = rx > 0 ? `round-${++this.names}` : "";
    const round = tag("clipPath", { id: name }, tag("rect", { ...place, rx: rounded(rx) }));
    const attributes = {
      ...place,
      preserveAspectRatio: fits,
      ...(rendering === "auto" ? {} : { "image-rendering": rendering }),
      ...(rx > 0 ? { "clip-path": `url(#${name})` } : {}),
      "xlink:href": href,
    };
    const words = label ? [tag("title", {}, escaped(label))] : [];
    return `${rx > 0 ? round : ""}${tag("image", attributes, ...words)}`;
  }

  private words(node: Text): void {
    const { parentElement: around } = node;
    if (!around || node.data === "") return;
    const style = styleOf(around);
    if (style("visibility") !== "visible") return;
    const size = Number.parseFloat(style("font-size")) || 0;
    const look = wordsLook(style);
    const range = document.createRange();
    const down = style("writing-mode").startsWith("vertical");
    const upper = style("text-transform") === "uppercase";
    if (down) {
      range.selectNodeContents(node);
      const { x, y, width, height } = range.getBoundingClientRect();
      if (width === 0 || height === 0) return;
      const { share } = letters(style);
      const run: Run = {
        text: node.data.trim(),
        x: x + width * (1 - share),
        y,
        width: height,
        look,
        size,
        align: "start",
        turn: 90,
      };
      this.parts.push(run);
      this.reach({ x, y, width, height });
      return;
    }
    const { share } = letters(style);
    let height = 0;
    const glyphs: Glyph[] = [];
    let at = 0;
    for (const text of node.data) {
      range.setStart(node, at);
      at += text.length;
      range.setEnd(node, at);
      const rect = [...range.getClientRects()].at(-1);
      if (rect) height = Math.max(height, rect.height);
      glyphs.push({ text, left: rect?.left ?? 0, top: rect?.top ?? 0, width: rect?.width ?? 0 });
    }
    for (const { text, left, top, width } of linesOf(glyphs)) {
      if (width <= 0) continue;
      const run = {
        text: upper ? text.toUpperCase() : text,
        x: left,
        y: top + share * height,
        width,
        look,
        size,
        align: alignOf(style("text-align")),
      };
      this.parts.push(run);
      if (text.trim() !== "") this.reach({ x: left, y: top, width, height });
    }
  }
}

/** Without its border and its padding. */
function contentOf(style: (property: string) => string, { x, y, width, height }: Box): Box {
  const edge = (side: string) =>
    (Number.parseFloat(style(`border-${side}-width`)) || 0) +
    (Number.parseFloat(style(`padding-${side}`)) || 0);
  const [left, top] = [edge("left"), edge("top")];
  return {
    x: x + left,
    y: y + top,
    width: Math.max(0, width - left - edge("right")),
    height: Math.max(0, height - top - edge("bottom")),
  };
}

/** At the resolution it was drawn at; null for one that is empty. */
function pngOf(element: HTMLCanvasElement | HTMLImageElement): string | null {
  if (element instanceof HTMLCanvasElement) {
    return element.width * element.height === 0 ? null : element.toDataURL("image/png");
  }
  if (element.naturalWidth === 0) return null;
  const canvas = document.createElement("canvas");
  canvas.width = element.naturalWidth;
  canvas.height = element.naturalHeight;
  canvas.getContext("2d")?.drawImage(element, 0, 0);
  return canvas.toDataURL("image/png");
}

const measured = new Map<string, number>();
let pen: CanvasRenderingContext2D | null = null;

/** How far down in its box the line is on which words of a font stand. */
function letters(style: (property: string) => string): { share: number } {
  const font = ["font-style", "font-weight", "font-size", "font-family"].map(style).join(" ");
  let share = measured.get(font);
  if (share === undefined) {
    pen ??= document.createElement("canvas").getContext("2d");
    if (pen) pen.font = font;
    const { fontBoundingBoxAscent: up = 0.8, fontBoundingBoxDescent: down = 0.2 } =
      pen?.measureText("x") ?? {};
    share = up / (up + down);
    measured.set(font, share);
  }
  return { share };
}

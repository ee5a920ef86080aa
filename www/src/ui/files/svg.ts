/** SVG files as text: the one place of the page that writes them. */

import { escaped as harmless } from "#format/html";
import { INK } from "#style/colours";

type Attributes = Readonly<Record<string, string | number | undefined>>;

/** An element. What is in it is written here as well, or made harmless by `escaped`. */
export function tag(name: string, attributes: Attributes, ...inner: string[]): string {
  const written = Object.entries(attributes)
    .map(([key, value]) => (value === undefined ? "" : ` ${key}="${escaped(String(value))}"`))
    .join("");
  return inner.length === 0
    ? `<${name}${written}/>`
    : `<${name}${written}>${inner.length === 1 ? inner[0] : `\n${inner.join("\n")}\n`}</${name}>`;
}

interface FileHead {
  /** Left, top, width, height. */
  box: readonly [number, number, number, number];
  title?: string;
  /** What it shows, for those who cannot see it. */
  about?: string;
  /** Of all that is in it. */
  style?: Attributes;
}

/** A whole file, as large as its box. */
export function svgFile({ box, title, about, style = {} }: FileHead, ...inner: string[]): string {
  const sizes = box.map(rounded);
  const attributes = {
    xmlns: "http://www.w3.org/2000/svg",
    viewBox: sizes.join(" "),
    width: sizes[2],
    height: sizes[3],
    ...style,
  };
  const told = [
    ...(title === undefined ? [] : [tag("title", {}, escaped(title))]),
    ...(about === undefined ? [] : [tag("desc", {}, escaped(about))]),
  ];
  return `${tag("svg", attributes, ...told, ...inner, "").replace(/\n+<\/svg>$/, "\n</svg>")}\n`;
}

/** What a drawing says of itself: of how many pieces it is made. Nothing of other texts. */
export function saidOf(text: string): string {
  const [, said = ""] = /<desc>([^<]*?)( Made by Frond\.)?<\/desc>/.exec(text) ?? [];
  return said.replace(/\d{4,}/g, (count) => count.replace(/\B(?=(\d{3})+$)/g, ","));
}

/** Letters that XML has not. */
const FORBIDDEN = /[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\u{10000}-\u{10ffff}]/gu;

export const escaped = (text: string): string => harmless(text.replace(FORBIDDEN, ""));

/** Hundredths are finer than what is drawn. */
export function rounded(x: number): number {
  return Math.round(100 * x) / 100;
}

const ANCHORS: Readonly<Record<string, string | undefined>> = { center: "middle", right: "end", end: "end" };
/** From the line on which words stand, in letters: programs differ in what they know of baselines. */
const RAISES: Readonly<Record<string, string | undefined>> = { top: "0.8em", middle: "0.35em" };

/** Draws as a canvas does, and writes it down: straight lines, rectangles and words. */
export function svgPen() {
  const parts: string[] = [];
  let path = "";
  const pen = {
    parts,
    fillStyle: INK as string,
    strokeStyle: INK as string,
    lineWidth: 1,
    /** "36px ..": the family is a generic one in the file. */
    font: "10px sans-serif",
    textAlign: "left" as CanvasTextAlign,
    textBaseline: "alphabetic" as CanvasTextBaseline,
    fillRect(x: number, y: number, width: number, height: number) {
      parts.push(tag("rect", { x, y, width, height, fill: pen.fillStyle }));
    },
    strokeRect(x: number, y: number, width: number, height: number) {
      const line = { stroke: pen.strokeStyle, "stroke-width": pen.lineWidth };
      parts.push(tag("rect", { x, y, width, height, fill: "none", ...line }));
    },
    beginPath() {
      path = "";
    },
    moveTo(x: number, y: number) {
      path += `M${rounded(x)} ${rounded(y)}`;
    },
    lineTo(x: number, y: number) {
      path += `L${rounded(x)} ${rounded(y)}`;
    },
    stroke() {
      const line = { stroke: pen.strokeStyle, "stroke-width": pen.lineWidth };
      parts.push(tag("path", { d: path, fill: "none", ...line }));
    },
    fillText(text: string, x: number, y: number) {
      const attributes = {
        x: rounded(x),
        y: rounded(y),
        dy: RAISES[pen.textBaseline],
        "text-anchor": ANCHORS[pen.textAlign],
        "font-family": "sans-serif",
        "font-size": Number.parseFloat(pen.font),
        fill: pen.fillStyle,
      };
      parts.push(tag("text", attributes, escaped(text)));
    },
  };
  return pen;
}

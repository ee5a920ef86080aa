import { readFile } from "node:fs/promises";
import { expect, test } from "./fixture";

test.use({ alone: true });

/**
 * Drawings made at random, read by Frond and drawn by the browser: both cover the same part of the page.
 * `FROND_DRAWINGS=2000` tries as many, `FROND_SEED` others.
 */
const DRAWINGS = Number(process.env["FROND_DRAWINGS"] ?? 80);
const SIZE = 200;

interface Outline {
  name: string;
  points: Float64Array;
}

/** Numbers from a seed: xorshift32. */
function numbers(seed: number): () => number {
  let state = seed | 1;
  return () => {
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) / 2 ** 32;
  };
}

/** Makes drawings: all that is said of where a shape lies may be in them. */
class Maker {
  #random: () => number;
  #defined: string[] = [];
  #rules: string[] = [];

  constructor(seed: number) {
    this.#random = numbers(seed);
  }

  drawing(): string {
    this.#defined = [];
    this.#rules = [];
    const inside = Array.from({ length: this.pick([1, 2, 3]) }, () => this.element(0)).join("");
    const page = this.pick([
      'viewBox="0 0 200 200" width="200" height="200"',
      'viewBox="-20 -10 240 260" width="200" height="200"',
      'viewBox="0 0 100 200" width="200" height="200" preserveAspectRatio="none"',
      'width="200px" height="200"',
    ]);
    const space = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"';
    const style = `<style>${this.#rules.join("")}</style>`;
    return `<svg ${space} ${page}>${style}<defs>${this.#defined.join("")}</defs>${inside}</svg>`;
  }

  private pick<T>(list: readonly T[]): T {
    return list[Math.floor(this.#random() * list.length)] as T;
  }

  private chance(share: number): boolean {
    return this.#random() < share;
  }

  private number(from: number, to: number): number {
    return Number((from + (to - from) * this.#random()).toFixed(this.pick([0, 2])));
  }

  private path(): string {
    let d = `M${this.number(20, 180)} ${this.number(20, 180)}`;
    const count = this.pick([2, 3, 5, 7]);
    for (let i = 0; i < count; i++) {
      const letter = this.pick([..."LlHhVvCcSsQqTtAaAaAa"]);
      const one = () => (letter < "a" ? this.number(10, 190) : this.number(-60, 60));
      const two = () => `${one()} ${one()}`;
      const flag = () => this.pick(["0", "1"]);
      const radii = `${this.number(1, 80)} ${this.number(1, 80)} ${this.number(-180, 180)}`;
      const arc = this.pick([` ${flag()} ${flag()} `, `,${flag()},${flag()},`, ` ${flag()}${flag()}`]);
      const rest = {
        L: two(),
        T: two(),
        H: String(one()),
        V: String(one()),
        C: `${two()},${two()} ${two()}`,
        S: `${two()} ${two()}`,
        Q: `${two()} ${two()}`,
        A: radii + arc + two(),
      };
      d += letter + rest[letter.toUpperCase() as keyof typeof rest];
    }
    return d + (this.chance(0.6) ? "Z" : "");
  }

  private transform(): string {
    const n = (from: number, to: number) => this.number(from, to);
    return this.pick([
      `translate(${n(-30, 30)},${n(-30, 30)})`,
      `rotate(${n(-90, 90)} ${n(50, 150)} ${n(50, 150)})`,
      `scale(${n(0.5, 1.5)} ${n(0.5, 1.5)})`,
      `skewX(${n(-30, 30)}) translate(${n(-9, 9)})`,
      `matrix(${n(0.7, 1.2)} ${n(-0.4, 0.4)} ${n(-0.4, 0.4)} ${n(0.7, 1.2)} ${n(-20, 20)} ${n(-20, 20)})`,
    ]);
  }

  /** A transform as style sheets write it, of a shape. */
  private style(): string {
    const n = (from: number, to: number) => this.number(from, to);
    const transform = this.pick([
      `transform:rotate(${n(-90, 90)}deg) scale(${n(0.6, 1.2)})`,
      `transform:translate(${n(-20, 20)}px,${n(-10, 10)}px) skew(${n(-20, 20)}deg)`,
      `rotate:${n(-90, 90)}deg;scale:${n(0.5, 1.2)} ${n(0.5, 1.2)}`,
      `translate:${n(-20, 20)}px ${n(-20, 20)}px`,
    ]);
    const origin = this.pick([
      "",
      ";transform-origin:50px 60px",
      ";transform-box:fill-box",
      ";transform-box:fill-box;transform-origin:center",
      ";transform-box:fill-box;transform-origin:100% 0",
    ]);
    return transform + origin;
  }

  private rule(declarations: string): string {
    const name = `k${this.#rules.length}`;
    this.#rules.push(`.${name}{${declarations}}`);
    return ` class="${name}"`;
  }

  private define(make: (id: string) => string): string {
    const id = `d${this.#defined.push("") - 1}`;
    this.#defined[Number(id.slice(1))] = make(id);
    return id;
  }

  private clip(): string {
    // Where shapes that go round in different ways overlap, Chromium lets nothing through: not as SVG has it.
    const shapes = () => (this.chance(0.6) ? this.shape("") : this.round("") + this.round(""));
    const own = '<rect x=".1" y=".2" width=".7" height=".6"/>';
    const id = this.define((id) =>
      this.chance(0.3)
        ? `<clipPath id="${id}" clipPathUnits="objectBoundingBox">${own}</clipPath>`
        : `<clipPath id="${id}">${shapes()}</clipPath>`,
    );
    return ` clip-path="url(#${id})"`;
  }

  private mask(): string {
    const white =
      '<rect x="-99" y="-99" width="400" height="400" fill="white"/><circle cx="100" cy="100" r="40"/>';
    const frame = 'maskUnits="userSpaceOnUse" x="-99" y="-99" width="400" height="400"';
    return ` mask="url(#${this.define((id) => `<mask id="${id}" ${frame}>${white}</mask>`)})"`;
  }

  /** What an element may have. */
  private look(styled: boolean): string {
    const parts = [
      [0.3, () => ` transform="${this.transform()}"`],
      [styled ? 0.2 : 0, () => (this.chance(0.7) ? ` style="${this.style()}"` : this.rule(this.style()))],
      [0.12, () => this.clip()],
      [0.04, () => this.mask()],
    ] as const;
    const hidden = [' visibility="hidden"', ' opacity="0"', ' display="none"', ' fill="none"'];
    const looks = parts.map(([share, part]) => (this.chance(share) ? part() : "")).join("");
    return looks + (this.chance(0.12) ? this.pick(hidden) : "");
  }

  /** A shape that goes round clockwise. */
  private round(look: string): string {
    const n = (from: number, to: number) => this.number(from, to);
    const corners = this.chance(0.5) ? ` rx="${n(0, 40)}"` : ` ry="${n(0, 70)}"`;
    return this.pick([
      () =>
        `<rect${look} x="${n(10, 90)}" y="${n(10, 90)}" width="${n(20, 99)}" height="${n(20, 99)}"${corners}/>`,
      () => `<circle${look} cx="${n(40, 160)}" cy="${n(40, 160)}" r="${n(10, 40)}"/>`,
      () => `<ellipse${look} cx="${n(40, 160)}" cy="${n(40, 160)}" rx="${n(10, 50)}" ry="${n(10, 50)}"/>`,
    ])();
  }

  private shape(look: string): string {
    const corner = () => `${this.number(10, 190)},${this.number(10, 190)}`;
    const corners = () => Array.from({ length: this.pick([4, 5, 7]) }, corner).join(" ");
    return this.pick([
      () => `<path${look} d="${this.path()}"/>`,
      () => this.round(look),
      () => `<polygon${look} points="${corners()}"/>`,
    ])();
  }

  private element(depth: number): string {
    const n = (from: number, to: number) => this.number(from, to);
    const kind = depth < 3 ? this.#random() : 1;
    const place = `x="${n(0, 50)}" y="${n(0, 50)}" width="${n(60, 150)}" height="${n(60, 150)}"`;
    const box = `viewBox="${n(-20, 20)} ${n(-20, 20)} ${n(100, 250)} ${n(100, 250)}"`;
    const fit = this.pick(["none", "xMinYMax", "xMaxYMin slice", "xMidYMid meet"]);
    if (kind < 0.2) return `<g${this.look(false)}>${this.element(depth + 1)}${this.element(depth + 1)}</g>`;
    if (kind < 0.3)
      return `<svg ${place} ${box} preserveAspectRatio="${fit}">${this.element(depth + 1)}</svg>`;
    if (kind < 0.4) {
      const id = this.define((id) => `<symbol id="${id}" ${box}>${this.element(depth + 1)}</symbol>`);
      return `<use${this.look(false)} href="#${id}" ${place}/>`;
    }
    if (kind < 0.45) {
      const id = this.define((id) => `<g id="${id}">${this.shape(this.look(false))}</g>`);
      return `<use${this.look(false)} xlink:href="#${id}" x="${n(-20, 20)}" y="${n(-20, 20)}"/>`;
    }
    return this.shape(this.look(true));
  }
}

/** What is common to the drawing as the browser draws it and the outlines, in parts of what either covers. */
async function common({
  text,
  outlines,
}: {
  text: string;
  outlines: number[][][];
}): Promise<[number, number]> {
  const context = () => {
    const made = new OffscreenCanvas(400, 400).getContext("2d");
    if (!made) throw new Error("no canvas");
    return made;
  };
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  await image.decode();
  const browser = context();
  browser.drawImage(image, 0, 0, 400, 400);
  URL.revokeObjectURL(image.src);
  const pixels = (of: OffscreenCanvasRenderingContext2D) => of.getImageData(0, 0, 400, 400).data;
  const theirs = pixels(browser);
  let best: [number, number] = [0, 0];
  // An outline has no holes: those of a shape are outlines of their own, and where one crosses itself both are tried.
  for (const rule of ["nonzero", "evenodd"] as const) {
    const own = context();
    own.scale(2, 2);
    for (const parts of outlines) {
      const path = new Path2D();
      for (const part of parts) {
        path.moveTo(part[0] ?? 0, -(part[1] ?? 0));
        for (let i = 2; i < part.length; i += 2) path.lineTo(part[i] ?? 0, -(part[i + 1] ?? 0));
        path.closePath();
      }
      own.fill(path, rule);
    }
    const ours = pixels(own);
    let [both, either] = [0, 0];
    for (let i = 3; i < ours.length; i += 4) {
      const [a, b] = [(ours[i] ?? 0) > 127, (theirs[i] ?? 0) > 127];
      if (a && b) both++;
      if (a || b) either++;
    }
    const share = either === 0 ? 1 : both / either;
    if (share >= best[0]) best = [share, either];
  }
  return best;
}

test("drawings are read as the browser draws them", async ({ page }) => {
  const drawings = await import("../../www/pkg/frond-svg.js");
  await drawings.default({
    module_or_path: readFile(new URL("../../www/pkg/frond-svg_bg.wasm", import.meta.url)),
  });
  const maker = new Maker(Number(process.env["FROND_SEED"] ?? 20261128));
  const apart: string[] = [];
  let compared = 0;
  for (let i = 0; i < DRAWINGS; i++) {
    const text = maker.drawing();
    let read: { outlines: Outline[]; warnings: { message: string }[] };
    try {
      read = drawings.readDrawing(new TextEncoder().encode(text));
    } catch (problem) {
      const { code } = problem as { code: string };
      expect(["nothing", "too-few-points", "flat"], text).toContain(code);
      continue;
    }
    const messages = read.warnings.map(({ message }) => message).join(" ");
    // Of what is hidden altogether, or crosses itself, the browser shows something else.
    if (/No shape of the drawing|crosses itself|too large/.test(messages)) continue;
    const shapes = new Map<string, number[][]>();
    for (const { name, points } of read.outlines) {
      const shape = name.replace(/, part .*/, "");
      shapes.set(shape, [...(shapes.get(shape) ?? []), [...points]]);
    }
    const [share, either] = await page.evaluate(common, { text, outlines: [...shapes.values()] });
    // Of little, the edges are much.
    if (either < SIZE) continue;
    compared++;
    if (share < 0.95) apart.push(`${share.toFixed(3)} ${text}`);
  }
  expect(compared).toBeGreaterThan(DRAWINGS / 2);
  expect(apart.join("\n")).toBe("");
});

/**
 * What the sliders of the hand come to: one transform, from how the object was when the hand was laid on it. In the
 * plane it is turned about z, and nothing is done along that axis (`inPlane`).
 */
import type { MapRow3, Point3 } from "#wasm/api";
import { about3, scale3, shift3, turns3 } from "./affine3";
import type { Row } from "./row";

export type Kind = "turn" | "move" | "scale" | "shear";

/** What a slider says: degrees, lengths, factors, and how far one axis slides with another. */
export type Numbers = Readonly<Record<string, number>>;

/** Where nothing is done. */
export const AT_REST: Readonly<Record<Kind, Numbers>> = {
  turn: { x: 0, y: 0, z: 0 },
  move: { x: 0, y: 0, z: 0 },
  scale: { all: 1, x: 1, y: 1, z: 1 },
  shear: { xy: 0, xz: 0, yx: 0, yz: 0, zx: 0, zy: 0 },
};

const DEGREE = Math.PI / 180;

export function transformOf(kind: Kind, numbers: Numbers, centre: Point3): MapRow3 {
  const n = (name: string) => numbers[name] ?? AT_REST[kind][name] ?? 0;
  switch (kind) {
    case "turn":
      return about3(turns3([n("x") * DEGREE, n("y") * DEGREE, n("z") * DEGREE]), centre);
    case "move":
      return shift3([n("x"), n("y"), n("z")]);
    case "scale":
      return about3(scale3([n("all") * n("x"), n("all") * n("y"), n("all") * n("z")]), centre);
    case "shear":
      return about3([1, n("xy"), n("xz"), n("yx"), 1, n("yz"), n("zx"), n("zy"), 1, 0, 0, 0], centre);
  }
}

/** Whether a transform is another but for rounding: the time line keeps them by their parts. */
export function nearlySame(p: Row, q: Row): boolean {
  const size = Math.max(1, ...p.map(Math.abs));
  return [...p].every((x, i) => Math.abs(x - (q[i] ?? 0)) <= 1e-7 * size);
}

/** A step that a slider of this reach moves by: 1, 2 or 5 of some power of ten, about a hundredth. */
export function stepOf(reach: number): number {
  const power = 10 ** Math.floor(Math.log10(reach / 100));
  const left = reach / 100 / power;
  return (left < 1.5 ? 1 : left < 3.5 ? 2 : left < 7.5 ? 5 : 10) * power;
}

/** Values of a slider that doubles and halves by even steps. */
export const toSlider = (factor: number) => Math.log2(Math.min(16, Math.max(1 / 16, Math.abs(factor) || 1)));
export const fromSlider = (at: number) => Number((2 ** at).toPrecision(3));

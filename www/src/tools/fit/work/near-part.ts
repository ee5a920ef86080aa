/** A part of the mask beside the one that is fitted, which may belong to it: a lobe that a pale stalk cuts off. */
import type { Component, Masked, Stroke } from "#workers/fit/trace-types";

export interface NearPart {
  /** Its place in the list of parts. */
  index: number;
  /** Its area in parts of that of the one that is fitted. */
  share: number;
  /** A stroke of leaf over the gap between the two. */
  stroke: Stroke;
}

/** As large as it has to be to be spoken of, in parts of the one that is fitted. */
const NOTABLE = 0.02;
/** As far away as it may be, in parts of the diagonal of the other's box. */
const NEAR = 0.05;
/** The gap is filled where it is no wider than this, in the same unit. */
const GAP = 0.035;
/** More points than this of a rim say nothing more. */
const LOOKS = 1500;

type Point = readonly [x: number, y: number];

interface Link {
  from: Point;
  to: Point;
  far: number;
}

/** The largest one beside the chosen, whose outline is x0, y0, x1, y1, .. in pixels, y down; null without any. */
export function nearPart(mask: Masked, chosen: number, outline: ArrayLike<number>): NearPart | null {
  const own = mask.components[chosen];
  if (!own || outline.length < 6) return null;
  const size = diagonal(own);
  const ring = thinned(pairs(outline));
  for (const [index, other] of mask.components.entries()) {
    if (index === chosen || other.area > own.area) continue;
    if (other.area < NOTABLE * own.area) break;
    if (!boxesNear(own, other, NEAR * size) || inside(other.at, ring)) continue;
    const links = thinned(rim(mask, other)).map((from) => linkTo(from, ring));
    const least = Math.min(...links.map(({ far }) => far));
    if (least > NEAR * size) continue;
    const wide = Math.max(GAP * size, 2 * least);
    const stroke = across(
      links.filter(({ far }) => far <= wide),
      Math.max(1.5, 0.004 * size),
    );
    return { index, share: other.area / own.area, stroke };
  }
  return null;
}

function diagonal({ box: [x0, y0, x1, y1] }: Component): number {
  return Math.hypot(x1 - x0, y1 - y0);
}

function boxesNear({ box: a }: Component, { box: b }: Component, far: number): boolean {
  return a[0] - far < b[2] && b[0] - far < a[2] && a[1] - far < b[3] && b[1] - far < a[3];
}

function pairs(points: ArrayLike<number>): Point[] {
  return Array.from({ length: Math.floor(points.length / 2) }, (_, i) => [
    points[2 * i] ?? 0,
    points[2 * i + 1] ?? 0,
  ]);
}

function thinned<T>(all: readonly T[]): T[] {
  const step = Math.max(1, all.length / LOOKS);
  return Array.from({ length: Math.floor(all.length / step) }, (_, i) => all[Math.floor(i * step)] as T);
}

function inside([x, y]: Point, ring: readonly Point[]): boolean {
  let odd = false;
  let [px, py] = ring.at(-1) ?? [0, 0];
  for (const [qx, qy] of ring) {
    if (qy > y !== py > y && x < qx + ((px - qx) * (y - qy)) / (py - qy)) odd = !odd;
    [px, py] = [qx, qy];
  }
  return odd;
}

/** The pixels of a part that have one beside them which is not of it. */
function rim({ width, mask }: Masked, { box: [x0, y0, x1, y1], at }: Component): Point[] {
  const [across, down] = [x1 - x0, y1 - y0];
  const seen = new Uint8Array(across * down);
  const on = (x: number, y: number) =>
    x >= 0 && y >= 0 && x < across && y < down && mask[(y + y0) * width + x + x0] !== 0;
  const found: Point[] = [];
  const todo = [(at[1] - y0) * across + at[0] - x0];
  for (let next = todo.pop(); next !== undefined; next = todo.pop()) {
    if (seen[next] !== 0) continue;
    seen[next] = 1;
    const [x, y] = [next % across, Math.floor(next / across)];
    let edge = false;
    // Parts hang together by corners, too.
    for (let v = y - 1; v <= y + 1; v++) {
      for (let u = x - 1; u <= x + 1; u++) {
        if (!on(u, v)) edge = true;
        else if (seen[v * across + u] === 0) todo.push(v * across + u);
      }
    }
    if (edge) found.push([x + x0 + 0.5, y + y0 + 0.5]);
  }
  return found;
}

function linkTo(from: Point, ring: readonly Point[]): Link {
  let best = Number.POSITIVE_INFINITY;
  let to = from;
  for (const one of ring) {
    const far = (one[0] - from[0]) ** 2 + (one[1] - from[1]) ** 2;
    if (far < best) [best, to] = [far, one];
  }
  return { from, to, far: Math.sqrt(best) };
}

/** A stroke that goes to and fro over a gap, along it as far as it has no break, from where it is narrowest. */
function across(links: readonly Link[], radius: number): Stroke {
  const middle = ({ from, to }: Link): Point => [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
  const [ux, uy] = direction(links.map(middle));
  const along = (link: Link) => middle(link)[0] * ux + middle(link)[1] * uy;
  const sorted = [...links].sort((a, b) => along(a) - along(b));
  const narrowest = sorted.reduce((best, { far }, i) => (far < (sorted[best]?.far ?? far) ? i : best), 0);
  const joined = (a: Link | undefined, b: Link | undefined) =>
    a !== undefined &&
    b !== undefined &&
    Math.hypot(middle(a)[0] - middle(b)[0], middle(a)[1] - middle(b)[1]) < 6 * radius;
  let [first, last] = [narrowest, narrowest];
  while (joined(sorted[first - 1], sorted[first])) first--;
  while (joined(sorted[last], sorted[last + 1])) last++;
  const round = (z: number) => Math.round(4 * z) / 4;
  const points: number[] = [];
  let there = Number.NEGATIVE_INFINITY;
  let back = false;
  for (const [i, link] of sorted.slice(first, last + 1).entries()) {
    // One swath beside the other; the narrowest place is never passed over.
    if (along(link) - there < radius && first + i !== narrowest) continue;
    there = along(link);
    const [a, b] = back ? [link.to, link.from] : [link.from, link.to];
    back = !back;
    points.push(round(a[0]), round(a[1]), round(b[0]), round(b[1]));
  }
  return { points, radius, what: "keep", exact: true };
}

/** The direction in which points lie, as a unit vector. */
function direction(points: readonly Point[]): Point {
  const count = Math.max(1, points.length);
  const mx = points.reduce((sum, [x]) => sum + x, 0) / count;
  const my = points.reduce((sum, [, y]) => sum + y, 0) / count;
  let [xx, xy, yy] = [0, 0, 0];
  for (const [x, y] of points) {
    xx += (x - mx) ** 2;
    xy += (x - mx) * (y - my);
    yy += (y - my) ** 2;
  }
  const angle = Math.atan2(2 * xy, xx - yy) / 2;
  return [Math.cos(angle), Math.sin(angle)];
}

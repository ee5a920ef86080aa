/**
 * The Bézier blend of a control mesh (Fujimoto et al., eq 14), as the page needs it: the display grid, and what pulls.
 */
import { type Mesh, type Point, placed, sizeOf } from "./mesh";

/** The Bernstein polynomials of degree `count - 1` at t, by de Casteljau's triangle. */
export function bernstein(t: number, count: number): number[] {
  const values = [1];
  for (let degree = 1; degree < count; degree++) {
    let carry = 0;
    for (let i = 0; i < degree; i++) {
      const here = values[i] ?? 0;
      values[i] = here * (1 - t) + carry;
      carry = here * t;
    }
    values.push(carry);
  }
  return values;
}

/** How much each control point moves the place (u, v) of the box, in parts of its sides; they sum to 1. */
export function weightsAt({ columns, rows }: Pick<Mesh, "columns" | "rows">, u: number, v: number): number[] {
  const across = bernstein(u, columns);
  return bernstein(v, rows).flatMap((y) => across.map((x) => x * y));
}

/** Where the place (u, v) of the box is at rest. */
export function restAt({ box: [x0, y0, x1, y1] }: Pick<Mesh, "box">, u: number, v: number): Point {
  return [x0 + (x1 - x0) * u, y0 + (y1 - y0) * v];
}

/** Where it goes. */
export function bentAt(mesh: Mesh, u: number, v: number): Point {
  let [x, y] = restAt(mesh, u, v);
  weightsAt(mesh, u, v).forEach((weight, i) => {
    x += weight * (mesh.moves[2 * i] ?? 0);
    y += weight * (mesh.moves[2 * i + 1] ?? 0);
  });
  return [x, y];
}

/** One line of the display grid: points and where it heads at each, by the length of one step between them. */
export interface GridLine {
  points: Point[];
  headings: Point[];
}

/** The display grid (the paper draws 11 x 11): `count` lines up, then as many across, through as many points each. */
export function gridLines(mesh: Mesh, count: number): GridLine[] {
  const { columns, rows } = mesh;
  const at = Array.from({ length: count }, (_, i) => i / (count - 1));
  const points = Array.from({ length: columns * rows }, (_, i) => placed(mesh, i));
  const up = at.map((u) => {
    const weights = bernstein(u, columns);
    return curve(rows, (j) => sum(weights, (i) => points[j * columns + i]));
  });
  const across = at.map((v) => {
    const weights = bernstein(v, rows);
    return curve(columns, (i) => sum(weights, (j) => points[j * columns + i]));
  });
  const line = (controls: Point[]): GridLine => {
    const steps = controls.slice(1).map((p, i): Point => difference(p, controls[i] ?? p));
    const degree = steps.length / (count - 1);
    return {
      points: at.map((t) => sum(bernstein(t, controls.length), (i) => controls[i])),
      headings: at.map((t) => {
        const [x, y] = sum(bernstein(t, steps.length), (i) => steps[i]);
        return [degree * x, degree * y];
      }),
    };
  };
  return [...up, ...across].map(line);
}

function curve(count: number, control: (i: number) => Point): Point[] {
  return Array.from({ length: count }, (_, i) => control(i));
}

function sum(weights: readonly number[], point: (i: number) => Point | undefined): Point {
  let [x, y] = [0, 0];
  weights.forEach((weight, i) => {
    const [px, py] = point(i) ?? [0, 0];
    x += weight * px;
    y += weight * py;
  });
  return [x, y];
}

function difference([px, py]: Point, [qx, qy]: Point): Point {
  return [px - qx, py - qy];
}

const SLIGHT = 1e-5;
const LOOKS = 24;
const STEPS = 12;

/**
 * The place of the box, and a little around it, that the mesh takes nearest to a point: by Newton's steps from the
 * nearest of a lattice of looks. Where the mesh is folded there are several: it is one of them.
 */
export function placeAt(mesh: Mesh, [x, y]: Point): Point {
  const miss = (u: number, v: number) => {
    const [p, q] = bentAt(mesh, u, v);
    return [p - x, q - y] as const;
  };
  let best: Point = [0.5, 0.5];
  let least = Number.POSITIVE_INFINITY;
  const keep = (u: number, v: number) => {
    const far = Math.hypot(...miss(u, v));
    if (!(far < least)) return false;
    least = far;
    best = [u, v];
    return true;
  };
  for (let i = 0; i <= LOOKS; i++) for (let j = 0; j <= LOOKS; j++) keep(i / LOOKS, j / LOOKS);
  const enough = 1e-9 * sizeOf(mesh.box);
  for (let step = 0; step < STEPS && least > enough; step++) {
    const [u, v] = best;
    const [ex, ey] = miss(u, v);
    const slope = (du: number, dv: number) => {
      const [px, py] = miss(u + du, v + dv);
      return [(px - ex) / SLIGHT, (py - ey) / SLIGHT] as const;
    };
    const [a, c] = slope(SLIGHT, 0);
    const [b, d] = slope(0, SLIGHT);
    const det = a * d - b * c;
    const du = (d * ex - b * ey) / det;
    const dv = (a * ey - c * ex) / det;
    if (!Number.isFinite(du) || !Number.isFinite(dv)) break;
    // Half the way, and half again, where the whole would lead away.
    let part = 1;
    while (part > 1e-3 && !keep(within(u - part * du), within(v - part * dv))) part /= 2;
    if (part <= 1e-3) break;
  }
  return best;
}

/** Far outside, the blend is of no use: its weights grow without bound. */
const BEYOND = 0.5;

function within(t: number): number {
  return Math.min(1 + BEYOND, Math.max(-BEYOND, t));
}

/** The paper's Fig 2, point by point, with every collision kept to be shown. */

export interface Window {
  x: number;
  y: number;
  side: number;
}

/** A square window about a box, larger than its longer side by `margin`, relative to it. */
export function windowOf(
  min: readonly [number, number],
  max: readonly [number, number],
  margin = 0.05,
): Window {
  const side = Math.max(max[0] - min[0], max[1] - min[1]) * (1 + margin) || 1;
  return { x: (min[0] + max[0] - side) / 2, y: (min[1] + max[1] - side) / 2, side };
}

export interface Edge {
  /** Two maps, the lower number first. */
  between: [number, number];
  /** After so many points it was first seen, counted from 1. */
  at: number;
  /** In this pixel. */
  pixel: number;
}

/** An index buffer on its way: each pixel holds the map whose piece was plotted there last. */
export class Collisions {
  readonly size: number;
  /** `size` x `size`, row 0 on top: 0 empty, else 1 + map. */
  readonly buffer: Uint8Array;
  /** How often two different pieces met in a pixel. */
  readonly met: Uint16Array;
  readonly edges: Edge[] = [];
  /** Points plotted. */
  count = 0;
  collisions = 0;
  readonly #window: Window;
  readonly #points: { positions: Float32Array; pieces: Uint8Array };

  constructor(size: number, window: Window, points: { positions: Float32Array; pieces: Uint8Array }) {
    this.size = size;
    this.buffer = new Uint8Array(size * size);
    this.met = new Uint16Array(size * size);
    this.#window = window;
    this.#points = points;
  }

  /** Plots on, up to `count` points in all. Going back is starting anew. */
  plotTo(count: number): void {
    const { positions, pieces } = this.#points;
    const until = Math.min(count, pieces.length);
    for (; this.count < until; this.count++) {
      const pixel = this.#pixel(positions[2 * this.count] ?? 0, positions[2 * this.count + 1] ?? 0);
      const piece = pieces[this.count] ?? 0;
      const before = (this.buffer[pixel] ?? 0) - 1;
      if (before >= 0 && before !== piece) this.#collide(before, piece, pixel);
      this.buffer[pixel] = piece + 1;
    }
  }

  #pixel(x: number, y: number): number {
    const { size } = this;
    const along = (p: number, from: number) =>
      Math.min(size - 1, Math.max(0, Math.floor(((p - from) / this.#window.side) * size)));
    return (size - 1 - along(y, this.#window.y)) * size + along(x, this.#window.x);
  }

  #collide(one: number, other: number, pixel: number): void {
    this.collisions++;
    this.met[pixel] = Math.min(65_535, (this.met[pixel] ?? 0) + 1);
    const [low, high] = one < other ? [one, other] : [other, one];
    if (this.edges.some(({ between: [i, j] }) => i === low && j === high)) return;
    this.edges.push({ between: [low, high], at: this.count + 1, pixel });
  }
}

/** In how many groups edges leave `count` vertices, and the group of each. */
export function groups(
  count: number,
  edges: readonly (readonly [number, number])[],
): { of: number[]; count: number } {
  const parent = Array.from({ length: count }, (_, i) => i);
  const root = (i: number): number => {
    const up = parent[i] ?? i;
    return up === i ? i : root(up);
  };
  for (const [i, j] of edges) parent[root(i)] = root(j);
  const names = new Map<number, number>();
  const of = parent.map((_, i) => {
    const r = root(i);
    if (!names.has(r)) names.set(r, names.size);
    return names.get(r) ?? 0;
  });
  return { of, count: names.size };
}

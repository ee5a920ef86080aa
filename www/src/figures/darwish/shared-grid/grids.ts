/** Grids, and shapes of each, to be laid over each other. */
import type { DigitSystem } from "#wasm/api";

export interface GridShape {
  id: string;
  name: string;
  system: DigitSystem;
}

export interface Grid {
  id: string;
  name: string;
  /** All its shapes lie on one line. */
  isLine: boolean;
  shapes: readonly GridShape[];
  /** How large `M x` is, for `x` of length 1. */
  scale: number;
}

type Digit = [x: number, y: number];
type Named = readonly [id: string, name: string, digits: readonly Digit[]];

function grid(
  id: string,
  name: string,
  matrix: DigitSystem["matrix"],
  shapes: readonly Named[],
  isLine = false,
): Grid {
  const [a, b, c, d] = matrix;
  return {
    id,
    name,
    isLine,
    scale: Math.sqrt(Math.abs(a * d - b * c)),
    shapes: shapes.map(([id, name, digits]) => ({ id, name, system: { matrix, digits: [...digits] } })),
  };
}

const times = (scale: number): DigitSystem["matrix"] => [scale, 0, 0, scale];
const onLine = (...digits: number[]): Digit[] => digits.map((x) => [x, 0]);
const line = (id: string, name: string, base: number, shapes: readonly Named[]) =>
  grid(id, name, times(base), shapes, true);

/** The cells of a square of so many rows that a test lets pass; the lowest row first. */
const cells = (rows: number, has: (x: number, y: number) => boolean): Digit[] =>
  Array.from({ length: rows * rows }, (_, k): Digit => [k % rows, Math.floor(k / rows)]).filter(([x, y]) =>
    has(x, y),
  );

export const GRIDS: readonly Grid[] = [
  line("line-3", "A line, by thirds", 3, [
    ["cantor", "Cantor’s set: 0, 2", onLine(0, 2)],
    ["left", "0, 1", onLine(0, 1)],
    ["interval", "An interval: 0, 1, 2", onLine(0, 1, 2)],
    ["wide", "With overlaps: 0, 1, 3", onLine(0, 1, 3)],
  ]),
  line("line-4", "A line, by quarters", 4, [
    ["ends", "Dust: 0, 3", onLine(0, 3)],
    ["three", "0, 1, 3", onLine(0, 1, 3)],
    ["other", "0, 2, 3", onLine(0, 2, 3)],
    ["interval", "An interval: 0, 1, 2, 3", onLine(0, 1, 2, 3)],
  ]),
  line("line-9", "A line, by ninths", 9, [
    ["cantor", "Cantor’s set, two steps at once: 0, 2, 6, 8", onLine(0, 2, 6, 8)],
    ["three", "0, 4, 8", onLine(0, 4, 8)],
    ["even", "0, 2, 4, 6, 8", onLine(0, 2, 4, 6, 8)],
    ["interval", "An interval: 0 to 8", onLine(0, 1, 2, 3, 4, 5, 6, 7, 8)],
  ]),
  grid("square-3", "Squares, by thirds", times(3), [
    ["carpet", "Carpet", cells(3, (x, y) => x !== 1 || y !== 1)],
    ["cross", "Vicsek’s cross", cells(3, (x, y) => x === 1 || y === 1)],
    ["saltire", "Vicsek’s cross, turned", cells(3, (x, y) => (x + y) % 2 === 0)],
    ["dust", "Cantor’s dust", cells(3, (x, y) => x !== 1 && y !== 1)],
    ["bars", "Bars", cells(3, (_, y) => y !== 1)],
    ["square", "A square", cells(3, () => true)],
  ]),
  grid("square-2", "Squares, by halves", times(2), [
    ["gasket", "Gasket, corner at the lower left", cells(2, (x, y) => x + y < 2)],
    ["upper-right", "Gasket, corner at the upper right", cells(2, (x, y) => x + y > 0)],
    ["lower-right", "Gasket, corner at the lower right", cells(2, (x, y) => x >= y)],
    ["upper-left", "Gasket, corner at the upper left", cells(2, (x, y) => x <= y)],
    ["square", "A square", cells(2, () => true)],
  ]),
  grid(
    "gauss-2",
    "Gaussian integers, by 1 + i",
    [1, -1, 1, 1],
    [
      [
        "dragon",
        "Twin dragon: 0, 1",
        [
          [0, 0],
          [1, 0],
        ],
      ],
      [
        "upright",
        "Twin dragon: 0, i",
        [
          [0, 0],
          [0, 1],
        ],
      ],
      [
        "far",
        "With a gap: 0, 3",
        [
          [0, 0],
          [3, 0],
        ],
      ],
    ],
  ),
  grid(
    "gauss-5",
    "Gaussian integers, by 2 + i",
    [2, -1, 1, 2],
    [
      [
        "tile",
        "Tile: 0, 1, i, −1, −i",
        [
          [0, 0],
          [1, 0],
          [0, 1],
          [-1, 0],
          [0, -1],
        ],
      ],
      [
        "ring",
        "Without its middle: 1, i, −1, −i",
        [
          [1, 0],
          [0, 1],
          [-1, 0],
          [0, -1],
        ],
      ],
      [
        "three",
        "Three arms: 0, 1, i, −1",
        [
          [0, 0],
          [1, 0],
          [0, 1],
          [-1, 0],
        ],
      ],
      [
        "corner",
        "A corner: 0, 1, i",
        [
          [0, 0],
          [1, 0],
          [0, 1],
        ],
      ],
    ],
  ),
];

/** The grid of a name, or else the first. */
export function gridOf(id: string): Grid {
  const found = GRIDS.find((grid) => grid.id === id) ?? GRIDS[0];
  if (!found) throw new Error("There is no grid.");
  return found;
}

/** The shape of a name, or else the first. */
export function shapeOf({ shapes }: Grid, id: string): GridShape {
  const found = shapes.find((shape) => shape.id === id) ?? shapes[0];
  if (!found) throw new Error("This grid has no shape.");
  return found;
}

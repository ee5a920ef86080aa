import { computed } from "@preact/signals";
import { deformation } from "#document/deform/bend";
import { placed } from "#geometry/mesh";
import type { Deformation } from "#wasm/api";
import css from "./strip.module.css";

// The moment is no part of it: nothing of this is drawn again while it plays.
const keys = computed(() => deformation.value.keys);
const columns = computed(() => deformation.value.columns);
const rows = computed(() => deformation.value.rows);
const box = computed(() => deformation.value.box);
const sides = computed(() => ({ columns: columns.value, rows: rows.value, box: box.value }));

/** All meshes of the time line in one frame, so that they can be compared. */
const frame = computed(() => frameOf({ ...sides.value, keys: keys.value }));

/** The control mesh of a key, small. */
export function MeshIcon({ index }: { index: number }) {
  const key = keys.value[index];
  if (!key) return null;
  const [x0, y0, x1, y1] = frame.value;
  const edge = 0.06 * Math.max(x1 - x0, y1 - y0);
  return (
    <svg
      class={css["mesh-icon"]}
      aria-hidden="true"
      viewBox={[x0 - edge, -y1 - edge, x1 - x0 + 2 * edge, y1 - y0 + 2 * edge]
        .map((x) => x.toPrecision(5))
        .join(" ")}
    >
      <path d={linesOf(sides.value, key.moves)} vector-effect="non-scaling-stroke" />
    </svg>
  );
}

type Sides = Pick<Deformation, "columns" | "rows" | "box">;

/** Its rows and columns, as one path; y points down. */
function linesOf(sides: Sides, moves: number[]): string {
  const { columns, rows } = sides;
  const at = (column: number, row: number) => {
    const [x, y] = placed({ ...sides, moves }, row * columns + column);
    return `${x.toPrecision(4)} ${(-y).toPrecision(4)}`;
  };
  const across = Array.from({ length: columns }, (_, i) => i);
  const up = Array.from({ length: rows }, (_, i) => i);
  return [
    ...up.map((row) => `M${across.map((column) => at(column, row)).join("L")}`),
    ...across.map((column) => `M${up.map((row) => at(column, row)).join("L")}`),
  ].join("");
}

function frameOf({ columns, rows, box, keys }: Pick<Deformation, "columns" | "rows" | "box" | "keys">) {
  let [x0, y0, x1, y1] = box;
  for (const { moves } of keys) {
    for (let i = 0; i < columns * rows; i++) {
      const [x, y] = placed({ columns, rows, box, moves }, i);
      x0 = Math.min(x0, x);
      y0 = Math.min(y0, y);
      x1 = Math.max(x1, x);
      y1 = Math.max(y1, y);
    }
  }
  return [x0, y0, x1, y1] as const;
}

import { allCodes, type Cube, cellOf, codeOf, codeWords, lettersOf } from "../codes/codes";
import { pickedClass, picking } from "../codes/picking";
import cubeCss from "./cube.module.css";

export interface CubePartProps {
  cube: Cube;
  /** Cells are drawn to this depth. */
  letters: number;
  point: readonly number[];
  /** What is seen, in words; null where its surroundings say it. */
  label: string | null;
}

const WIDTH = 400;
const ROW = 26;
/** A letter needs so much room. */
const GLYPH = 7.5;

/** The unit line: a row for each letter, with the parts of the row above divided anew. */
export function CubeLine({
  cube,
  letters,
  point,
  label,
  onPick,
}: CubePartProps & { onPick?: (x: number) => void }) {
  const rows = Array.from({ length: letters }, (_, i) => i + 1);
  const height = ROW * letters;
  const x = Math.min(1, Math.max(0, point[0] ?? 0)) * WIDTH;
  return (
    <svg
      class={`${cubeCss["cube"]} ${onPick ? pickedClass : ""}`}
      viewBox={`-1 -1 ${WIDTH + 2} ${height + 2}`}
      role="img"
      aria-hidden={label === null}
      aria-label={label ?? ""}
      {...(onPick ? picking(([at]) => onPick(at)) : {})}
    >
      {rows.map((depth) => (
        <Row key={depth} cube={cube} depth={depth} code={codeOf(cube, point, depth)} />
      ))}
      <path class={cubeCss["cube-point"]} d={`M${x} -1V${height + 1}`} />
    </svg>
  );
}

function Row({ cube, depth, code }: { cube: Cube; depth: number; code: number[] }) {
  const parts = cube.parts ** depth;
  const side = WIDTH / parts;
  const top = ROW * (depth - 1);
  const here = cellOf(cube, code).corner[0] ?? 0;
  const lines = Array.from({ length: parts - 1 }, (_, i) => `M${side * (i + 1)} ${top}v${ROW}`);
  const labelled = side > GLYPH * depth + 2;
  return (
    <g>
      <rect class={cubeCss["cube-here"]} x={here * WIDTH} y={top} width={side} height={ROW} />
      <path
        class={cubeCss["cube-lines"]}
        d={`M0 ${top}h${WIDTH}v${ROW}h-${WIDTH}z${side > 2.5 ? lines.join("") : ""}`}
      />
      {labelled &&
        allCodes(lettersOf(cube), depth).map((cell, i) => (
          <text key={codeWords(cell)} x={(i + 0.5) * side} y={top + ROW / 2} dy="0.35em" text-anchor="middle">
            {codeWords(cell)}
          </text>
        ))}
    </g>
  );
}

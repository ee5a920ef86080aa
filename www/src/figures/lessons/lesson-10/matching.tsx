import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import css from "./matching.module.css";

/** In words: "1 to 2, 2 to 1, 3 to 3". */
export function matchingWords(matching: readonly number[]): string {
  return matching.map((to, from) => `${from + 1} to ${to + 1}`).join(", ");
}

const STEP = 30;

/** Two rows of numbers with a line from each above to the one below that it becomes. */
export function Matching({ matching, wide = false }: { matching: readonly number[]; wide?: boolean }) {
  const colours = palette(dark.value ? "dark" : "light");
  const x = (i: number) => STEP * i + STEP / 2;
  return (
    <svg
      class={`${css["matching"]} ${wide ? css["wide"] : ""}`}
      viewBox={`0 0 ${STEP * matching.length} 64`}
      aria-hidden="true"
    >
      {matching.map((to, from) => (
        <path key={`${from + 1}`} style={{ color: colours[from] }} d={`M${x(from)} 18L${x(to)} 46`} />
      ))}
      {matching.map((_, i) => (
        <g key={`${i + 1}`}>
          <text x={x(i)} y={13} text-anchor="middle">
            {i + 1}
          </text>
          <text x={x(i)} y={60} text-anchor="middle">
            {i + 1}
          </text>
        </g>
      ))}
    </svg>
  );
}

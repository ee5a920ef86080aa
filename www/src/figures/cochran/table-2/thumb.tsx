import { useMemo } from "preact/hooks";
import { TABLE_2 } from "../graphs/printed-tables";
import { type Dots, type Line, Profile } from "../graphs/profile";
import { NO_TICKS } from "../graphs/still";

const NO_LINES: readonly Line[] = [];

/** The printed rows of Table 2 over a and b, as large as they are popular. */
export function Thumb() {
  const dots = useMemo(
    () =>
      TABLE_2.map(({ hits, map }, i): Dots => {
        return {
          points: [map[3], map[4]],
          colour: i < 2 ? 5 : 1,
          size: 0.2 * Math.sqrt(hits),
          hollow: i > 1,
        };
      }),
    [],
  );
  return (
    <Profile
      bare
      label={null}
      x={{ min: -1.4, max: 1, ticks: NO_TICKS }}
      y={{ min: -1.1, max: 2.1, ticks: NO_TICKS }}
      lines={NO_LINES}
      dots={dots}
    />
  );
}

import { useMemo } from "preact/hooks";
import { type Line, Profile } from "../graphs/profile";
import { NO_TICKS } from "../graphs/still";

/** Heaps that fall as those of votes do. */
export function Thumb() {
  const lines = useMemo(
    () =>
      Array.from({ length: 34 }, (_, i): Line => {
        return { points: [i, 0, i, 1 / (1 + 0.28 * i)], colour: i % 5 === 0 ? 5 : 1, width: 3 };
      }),
    [],
  );
  return (
    <Profile
      bare
      label={null}
      x={{ min: -1, max: 34, ticks: NO_TICKS }}
      y={{ min: 0, max: 1.05, ticks: NO_TICKS }}
      lines={lines}
    />
  );
}

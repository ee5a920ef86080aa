import { rangeOf } from "./graphs";
import { type Line, Profile } from "./profile";

export const NO_TICKS: readonly number[] = [];

/** The graph of a function without axes, small. */
export function Still({ lines, t }: { lines: readonly Line[]; t: readonly [number, number] }) {
  const y = rangeOf(
    lines.map(({ points }) => points),
    { min: 0, max: 1 },
  );
  return (
    <Profile
      bare
      label={null}
      x={{ min: t[0], max: t[1], ticks: NO_TICKS }}
      y={{ ...y, ticks: NO_TICKS }}
      lines={lines}
    />
  );
}

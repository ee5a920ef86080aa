import { fixed } from "#format/numbers";
import locusCss from "#stage/locus/locus.module.css";
import { ticksOf } from "./geometry";
import { large } from "./large";
import { family, shownWindow } from "./view";

/** Deeper than this the numbers are too long to stand at an axis: the window is told below. */
const MOST_DIGITS = 3;

const NAMES = { morph: { u: "u", v: "v" }, polygon: { u: "Re s", v: "Im s" } };

/** Numbers along one side. */
export function Ticks({ axis }: { axis: "u" | "v" }) {
  const { u0, u1, v0, v1 } = shownWindow.value;
  const [low, high] = axis === "u" ? [u0, u1] : [v0, v1];
  const { at, digits } = ticksOf(low, high, large.value ? 7 : family.value === "morph" ? 3 : 4);
  const part = (x: number) => `${(100 * (x - low)) / (high - low)}%`;
  return (
    <div class={`${locusCss["locus-ticks"]} ${axis}`} aria-hidden="true">
      {at.map((x) => (
        <span
          key={x}
          class={x - low < 0.03 * (high - low) ? "first" : high - x < 0.03 * (high - low) ? "last" : ""}
          style={{ "--at": part(x) }}
        >
          {digits <= MOST_DIGITS && <b>{fixed(x, digits)}</b>}
        </span>
      ))}
      <em>{NAMES[family.value][axis]}</em>
    </div>
  );
}

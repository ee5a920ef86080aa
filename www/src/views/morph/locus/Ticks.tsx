import { fixed } from "../../../ui/number";
import { family, shownWindow } from "./view";

/** Round numbers of a window, about so many, and the decimals that tell them apart. */
export function ticksOf(low: number, high: number, count = 4): { at: number[]; digits: number } {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((k) => k * power).find((s) => s >= rough * 0.99) ?? rough;
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const at: number[] = [];
  const first = Math.ceil(low / step - 1e-9);
  for (let k = first; k * step <= high + 1e-9 * step && at.length < 9; k++)
    at.push(Number((k * step).toFixed(20)));
  return { at, digits };
}

/** Deeper than this the numbers are too long to stand at an axis: the window is told below. */
const MOST_DIGITS = 3;

const NAMES = { morph: { u: "u", v: "v" }, polygon: { u: "Re s", v: "Im s" } };

/** Numbers along one side. */
export function Ticks({ axis }: { axis: "u" | "v" }) {
  const { u0, u1, v0, v1 } = shownWindow.value;
  const [low, high] = axis === "u" ? [u0, u1] : [v0, v1];
  const { at, digits } = ticksOf(low, high, family.value === "morph" ? 3 : 4);
  const part = (x: number) => `${(100 * (x - low)) / (high - low)}%`;
  return (
    <div class={`locus-ticks ${axis}`} aria-hidden="true">
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

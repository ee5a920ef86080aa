import { fixed } from "#format/numbers";
import locusCss from "#stage/locus/locus.module.css";
import * as messages from "../messages";
import { countOf, originOf, ticksOf } from "./geometry";
import { large } from "./large";
import { family, shownWindow } from "./view";

/** What the axes are called. */
export const NAMES = { morph: { u: "u", v: "v" }, polygon: { u: "Re s", v: "Im s" } };

/** The same beside what they do. */
const WORDS = { morph: { u: messages.uRotate, v: messages.moveV }, polygon: NAMES.polygon };

/** A map that is narrower has fewer numbers, in CSS pixels of the page. */
const NARROW = 600;

/** What is told along one side. */
export function axisOf(axis: "u" | "v") {
  const { u0, u1, v0, v1 } = shownWindow.value;
  const [low, high] = axis === "u" ? [u0, u1] : [v0, v1];
  // Between them there is room for the names, on a phone too.
  const most = large.value ? (innerWidth < NARROW ? 4 : 7) : family.value === "morph" ? 3 : 4;
  const { at, digits } = ticksOf(low, high, most);
  return { low, high, at, digits, origin: originOf(low, high, digits) };
}

const signed = (n: number) => (n > 0 ? `+${n}` : `${n}`.replace("-", "−"));

/** Numbers along one side. */
export function Ticks({ axis }: { axis: "u" | "v" }) {
  const { low, high, at, digits, origin } = axisOf(axis);
  const part = (x: number) => `${(100 * (x - low)) / (high - low)}%`;
  // Between two numbers near the middle.
  const near = at.length >> 1;
  return (
    <div class={`${locusCss["locus-ticks"]} ${axis}`} aria-hidden="true">
      {at.map((x) => (
        <span
          key={x}
          class={x - low < 0.03 * (high - low) ? "first" : high - x < 0.03 * (high - low) ? "last" : ""}
          style={{ "--at": part(x) }}
        >
          <b>{origin ? signed(countOf(x, origin)) : fixed(x, digits)}</b>
        </span>
      ))}
      {!origin && (
        <em style={{ "--at": part(((at[near - 1] ?? low) + (at[near] ?? high)) / 2) }}>
          {WORDS[family.value][axis]}
        </em>
      )}
    </div>
  );
}

import { Small } from "../../kit/picture/small";
import { type Curve, pointsOf } from "./curves";
import css from "./square.module.css";

const A: Curve = { from: 3.5, to: 1.5, swing: 0.25 };
const B: Curve = { from: 0.35, to: 2.4, swing: -0.2 };
const path = (curve: Curve) =>
  `M${pointsOf(curve)
    .map(([x, y]) => `${(100 * x).toFixed(1)} ${(100 - 100 * y).toFixed(1)}`)
    .join("L")}`;

export function Thumb() {
  return (
    <Small>
      <svg viewBox="-4 -4 108 108" aria-hidden="true">
        <rect class={css["crossing-frame"]} width={100} height={100} />
        <path class={css["curve-a"]} d={path(A)} />
        <path class={css["curve-b"]} d={path(B)} />
      </svg>
    </Small>
  );
}

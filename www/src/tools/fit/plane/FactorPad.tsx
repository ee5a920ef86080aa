import { announce } from "#document/notice";
import { fixed } from "#format/numbers";
import { screen } from "#geometry/coordinates";
import { useGrip } from "#stage/grip";
import * as messages from "../messages";
import type { Factor } from "./model/curve";
import { norm } from "./model/curve";
import { curve, problem, refused, setFactor } from "./model/document";
import css from "./plane.module.css";

const SIZE = 208;
/** CSS pixels of a unit: what lies outside the circle of 1 is seen, too. */
const UNIT = 72;
const STEP = 0.05;
const FINE_STEP = 0.005;

const left = (x: number) => SIZE / 2 + UNIT * x;
const top = (y: number) => SIZE / 2 - UNIT * y;

/** What a factor makes of the circle of 1, as the data of a path. */
function ellipse([cx, cxy, cyx, cy]: Factor): string {
  const steps = 72;
  const point = (i: number) => {
    const [x, y] = [Math.cos((2 * Math.PI * i) / steps), Math.sin((2 * Math.PI * i) / steps)];
    return `${left(cx * x + cxy * y).toFixed(1)} ${top(cyx * x + cy * y).toFixed(1)}`;
  };
  return `M${Array.from({ length: steps }, (_, i) => point(i)).join("L")}Z`;
}

interface FactorPadProps {
  piece: number;
  factor: Factor;
  /** x answers to x alone, y to y. */
  apart: boolean;
}

/** A factor by hand: where it takes the two directions of the plane, and the circle that it must stay in. */
export function FactorPad({ piece, factor, apart }: FactorPadProps) {
  const bad = refused.value?.piece === piece ? refused.value.factor : null;
  const [cx, cxy, cyx, cy] = factor;
  return (
    <svg class={css["pad"]} width={SIZE} height={SIZE} viewBox={`0 0 ${SIZE} ${SIZE}`}>
      <title>{messages.circleOf(piece + 1, fixed(norm(factor), 3))}</title>
      <path class={css["cross"]} d={`M0 ${SIZE / 2}H${SIZE}M${SIZE / 2} 0V${SIZE}`} />
      <circle class={css["factor-ring"]} cx={SIZE / 2} cy={SIZE / 2} r={UNIT} />
      <path class={css["image"]} d={ellipse(factor)} />
      {bad && <path class={css["bad"]} d={ellipse(bad)} />}
      <Arrow piece={piece} axis={0} apart={apart} x={cx} y={cyx} />
      <Arrow piece={piece} axis={1} apart={apart} x={cxy} y={cy} />
    </svg>
  );
}

/** Where a direction goes. */
function Arrow(props: { piece: number; axis: 0 | 1; apart: boolean; x: number; y: number }) {
  const { piece, axis, apart, x, y } = props;
  const name = axis === 0 ? "x" : "y";
  const move = (to: readonly [number, number], gesture: string) => {
    const old = curve.peek().pieces[piece]?.factor;
    if (!old) return false;
    const next: Factor = [...old];
    const [across, up] = to.map((value) => Math.round(1000 * value) / 1000) as [number, number];
    if (axis === 0 || !apart) next[axis] = across;
    if (axis === 1 || !apart) next[axis + 2] = up;
    return setFactor(piece, next, gesture);
  };
  const grip = useGrip({
    take: () => screen(left(x), top(y)),
    moveTo: (to) =>
      void move([(to.x - SIZE / 2) / UNIT, (SIZE / 2 - to.y) / UNIT], `drag factor ${piece} ${axis}`),
    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return false;
      const by = event.shiftKey ? FINE_STEP : STEP;
      const ways: Record<string, readonly [number, number]> = {
        ArrowLeft: [x - by, y],
        ArrowRight: [x + by, y],
        ArrowUp: [x, y + by],
        ArrowDown: [x, y - by],
      };
      const to = ways[event.key];
      if (!to) return false;
      if (!move(to, `keys factor ${piece} ${axis}`)) announce(problem.peek() ?? "");
      return true;
    },
  });
  return (
    <>
      <path class={css["arrow"]} d={`M${left(0)} ${top(0)}L${left(x).toFixed(1)} ${top(y).toFixed(1)}`} />
      {/* biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG */}
      <g
        ref={grip}
        class="grip"
        data-handle=""
        role="button"
        tabindex={0}
        aria-label={messages.takesTo(piece + 1, name, fixed(x, 3), fixed(y, 3))}
        transform={`translate(${left(x).toFixed(1)} ${top(y).toFixed(1)})`}
      >
        <circle class={css["factor-reach"]} r={18} />
        <circle class="knob" r={6} />
        <text class={css["factor-axis"]} x={9} y={-8}>
          {name}
        </text>
      </g>
    </>
  );
}

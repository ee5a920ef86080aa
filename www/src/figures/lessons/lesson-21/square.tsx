import { useRef } from "preact/hooks";
import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import type { Point } from "../../kit/maps/pieces";
import { type Curve, meeting, onBorder, placeOf, pointsOf, takeTurns } from "./curves";
import css from "./square.module.css";

interface SquareProps {
  a: Curve;
  b: Curve;
  onB: (b: Curve) => void;
}

const SIDE = 300;
const EDGE = 24;
const place = ([x, y]: Point): Point => [EDGE + SIDE * x, EDGE + SIDE * (1 - y)];
const path = (curve: Curve) =>
  `M${pointsOf(curve)
    .map((p) =>
      place(p)
        .map((x) => x.toFixed(1))
        .join(" "),
    )
    .join("L")}`;

/** Both curves in their square; the ends of B can be dragged round it. */
export function Square({ a, b, onB }: SquareProps) {
  const host = useRef<SVGSVGElement>(null);
  const met = meeting(a, b);
  const drag = (end: "from" | "to") => (event: PointerEvent) => {
    const box = host.current?.getBoundingClientRect();
    const handle = event.currentTarget as Element;
    if (!box) return;
    if (event.type === "pointerdown") handle.setPointerCapture(event.pointerId);
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const whole = SIDE + 2 * EDGE;
    const x = ((event.clientX - box.left) / box.width) * whole;
    const y = ((event.clientY - box.top) / box.height) * whole;
    onB({ ...b, [end]: placeOf([(x - EDGE) / SIDE, 1 - (y - EDGE) / SIDE]) });
  };
  const [x, y] = met ? place(met) : [0, 0];
  return (
    <svg
      ref={host}
      class={css["crossing-square"]}
      viewBox={`0 0 ${SIDE + 2 * EDGE} ${SIDE + 2 * EDGE}`}
      role="img"
      aria-label={`Curve A and curve B in a square. ${words(a, b)}`}
    >
      <rect class={css["crossing-frame"]} x={EDGE} y={EDGE} width={SIDE} height={SIDE} />
      <path class={css["curve-a"]} d={path(a)} />
      <path class={css["curve-b"]} d={path(b)} />
      {met && <circle class={css["meeting-ring"]} cx={x} cy={y} r={9} />}
      {(["from", "to"] as const).map((end) => (
        <End key={end} name="A" at={place(onBorder(a[end]))} />
      ))}
      {(["from", "to"] as const).map((end) => (
        <g key={end} class={css["end-held"]} onPointerDown={drag(end)} onPointerMove={drag(end)}>
          <End name="B" at={place(onBorder(b[end]))} />
        </g>
      ))}
    </svg>
  );
}

function End({ name, at: [x, y] }: { name: "A" | "B"; at: Point }) {
  return (
    <g class={name === "A" ? css["end-a"] : css["end-b"]} transform={`translate(${x} ${y})`}>
      <circle class={css["end-reach"]} r={22} />
      <circle r={11} />
      <text dy="0.35em" text-anchor="middle">
        {name}
      </text>
    </g>
  );
}

/** What is so of both, in words. */
export function words(a: Curve, b: Curve): string {
  const here = meeting(a, b) ? "Here they meet." : "Here they do not meet.";
  return takeTurns(a, b)
    ? `Round the square the ends take turns: A, B, A, B. They must meet. ${here}`
    : `The ends do not take turns. They need not meet. ${here}`;
}

const SIDES = ["bottom", "right", "top", "left"] as const;

/** Where both ends of B are. */
export function Ends({ b, onB }: Pick<SquareProps, "b" | "onB">) {
  return (
    <div class={layout["controls"]}>
      {(["from", "to"] as const).map((end, i) => {
        const at = ((b[end] % 4) + 4) % 4;
        return (
          <SliderControl
            key={end}
            label={`${i === 0 ? "first" : "second"} end of B, round the square`}
            range={[0, 4]}
            step={0.05}
            value={at}
            text={`${SIDES[Math.min(3, Math.floor(at))]} side`}
            valueText={`${fixed(at)} of 4 sides: ${SIDES[Math.min(3, Math.floor(at))]} side`}
            onChange={(next) => onB({ ...b, [end]: next })}
          />
        );
      })}
    </div>
  );
}

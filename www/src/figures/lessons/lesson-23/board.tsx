import { useMemo, useRef } from "preact/hooks";
import { fitFor } from "#document/framing";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import { apply, type Point } from "../../kit/maps/pieces";
import { Span } from "../../kit/picture/annotated";
import { Picture } from "../../kit/picture/picture";
import { useValue } from "../../kit/workers";
import css from "./board.module.css";
import { type Copy, mapOf, tame } from "./collage";
import { BOX, CENTRE, OUTLINE } from "./leaf";
import type { Worst } from "./raster";

interface BoardProps {
  copies: readonly Copy[];
  label: string | null;
  /** The copy that has the grip. */
  chosen?: number;
  /** What the maps make is drawn, too. */
  made?: boolean;
  /** Where it is worst. */
  worst?: Worst | null;
  onChange?: (index: number, copy: Copy) => void;
  onChoose?: (index: number) => void;
}

const [WIDTH, HEIGHT] = [400, 300];
const MARGIN = 0.02;
/** The grip is above the tip of the copy. */
const TIP: Point = [0, 1.06];

const { x: MIDDLE_X, y: MIDDLE_Y, scale: SCALE } = fitFor(BOX, { width: WIDTH, height: HEIGHT }, MARGIN);
const place = ([x, y]: Point): Point => [
  WIDTH / 2 + (x - MIDDLE_X) * SCALE,
  HEIGHT / 2 - (y - MIDDLE_Y) * SCALE,
];
const pathOf = (points: readonly Point[]) =>
  `M${points
    .map((point) =>
      place(point)
        .map((x) => x.toFixed(1))
        .join(" "),
    )
    .join("L")}Z`;

/** Where in the plane a pointer is. */
function planeOf(event: PointerEvent, svg: SVGSVGElement): Point {
  const { left, top, width, height } = svg.getBoundingClientRect();
  const [u, v] = [((event.clientX - left) / width) * WIDTH, ((event.clientY - top) / height) * HEIGHT];
  return [MIDDLE_X + (u - WIDTH / 2) / SCALE, MIDDLE_Y - (v - HEIGHT / 2) / SCALE];
}

/** The leaf, the copies that cover it, and a grip that turns and sizes one of them. */
export function Board({ copies, label, chosen, made = false, worst, onChange, onChoose }: BoardProps) {
  const svg = useRef<SVGSVGElement>(null);
  const drag = useRef<{ index: number; grip: boolean; off: Point } | null>(null);
  const colours = palette(useValue(dark) ? "dark" : "light");
  const maps = useMemo(() => copies.map(mapOf), [copies]);

  const begin = (index: number, grip: boolean) => (event: PointerEvent) => {
    if (!svg.current || !onChange || event.button !== 0) return;
    // Followed by the board itself: what was pressed may be drawn anew.
    svg.current.setPointerCapture(event.pointerId);
    const [x, y] = planeOf(event, svg.current);
    const [u, v] = copies[index]?.at ?? [x, y];
    drag.current = { index, grip, off: [u - x, v - y] };
    onChoose?.(index);
  };
  const move = (event: PointerEvent) => {
    const held = drag.current;
    const copy = held && copies[held.index];
    if (!held || !copy || !svg.current?.hasPointerCapture(event.pointerId)) return;
    const to = planeOf(event, svg.current);
    const [x, y] = copy.at;
    if (held.grip) {
      const [dx, dy] = [to[0] - x, to[1] - y];
      const turn = (Math.atan2(-dx, dy) * 180) / Math.PI;
      onChange?.(held.index, tame({ ...copy, turn, size: Math.hypot(dx, dy) / (TIP[1] - CENTRE[1]) }));
    } else {
      onChange?.(held.index, tame({ ...copy, at: [to[0] + held.off[0], to[1] + held.off[1]] }));
    }
  };
  const end = () => {
    drag.current = null;
  };

  const held = chosen === undefined ? undefined : maps[chosen];
  return (
    <div class={css["board"]}>
      {made && <Picture maps={maps} box={BOX} margin={MARGIN} label={null} />}
      <svg
        ref={svg}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        role="img"
        aria-label={label ?? undefined}
        aria-hidden={label === null}
        onPointerMove={move}
        onPointerUp={end}
        onPointerCancel={end}
      >
        {maps.map((map, i) => (
          <path
            // Copies have no name but their number: it is their key.
            key={`${i + 1}`}
            class={`${css["copy"]} ${onChange ? css["moved"] : ""} ${made ? css["bare"] : ""} ${i === chosen ? css["chosen"] : ""}`}
            style={{ color: colours[i] }}
            d={pathOf(OUTLINE.map((point) => apply(map, point)))}
            onPointerDown={begin(i, false)}
          />
        ))}
        <path class={css["leaf"]} d={pathOf(OUTLINE)} pointer-events="none" />
        {worst && worst.distance > 0 && (
          <g pointer-events="none">
            <Span from={place(worst.from)} to={place(worst.to)} kind="strong" />
          </g>
        )}
        {held && chosen !== undefined && (
          <Grip from={place(apply(held, CENTRE))} to={place(apply(held, TIP))} onDown={begin(chosen, true)} />
        )}
      </svg>
    </div>
  );
}

interface GripProps {
  from: Point;
  to: Point;
  onDown: (event: PointerEvent) => void;
}

function Grip({ from, to: [cx, cy], onDown }: GripProps) {
  return (
    <>
      <line class={css["stem"]} x1={from[0]} y1={from[1]} x2={cx} y2={cy} pointer-events="none" />
      <g class={css["grip"]} onPointerDown={onDown}>
        <circle class={css["reach"]} cx={cx} cy={cy} r={24} />
        <circle cx={cx} cy={cy} r={8} />
      </g>
    </>
  );
}

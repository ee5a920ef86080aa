import { useLayoutEffect, useMemo, useRef } from "preact/hooks";
import type { Point } from "../../kit/maps/pieces";
import { pictured } from "../../kit/picture/canvas";
import { cellOf, codeOf } from "../codes/codes";
import { pickedClass, picking } from "../codes/picking";
import css from "./shuffle-matrix.module.css";
import { type Subject, shuffledImage } from "./shuffled-image";

/** The largest ke, and with it the number of letters that are shuffled. */
export const COLUMNS = 5;
const ROWS = [0, 1, 2] as const;

/** One image of the matrix. */
export interface Chosen {
  kb: number;
  ke: number;
  superposed: boolean;
}

export function cellWords({ kb, ke, superposed }: Chosen): string {
  return superposed ? `kb ${kb}, all ke to ${ke} superposed` : `kb ${kb}, ke ${ke}`;
}

interface MatrixProps {
  subject: Subject;
  chosen: Chosen;
  onChoose: (chosen: Chosen) => void;
}

/** Images by locality and detail, the superposition of each row at its end. Arrow keys walk through them. */
export function Matrix({ subject, chosen, onChoose }: MatrixProps) {
  const host = useRef<HTMLDivElement>(null);
  const rows = ROWS.map((kb) => [
    ...Array.from({ length: COLUMNS - kb + 1 }, (_, i): Chosen => ({ kb, ke: kb + i, superposed: false })),
    { kb, ke: COLUMNS, superposed: true },
  ]);
  const columnOf = ({ ke, superposed }: Chosen) => (superposed ? COLUMNS + 1 : ke);
  const walk = (event: KeyboardEvent) => {
    const by = { ArrowRight: [0, 1], ArrowLeft: [0, -1], ArrowDown: [1, 0], ArrowUp: [-1, 0] }[event.key];
    if (!by) return;
    const next = rows[chosen.kb + (by[0] ?? 0)]?.find(
      (one) => columnOf(one) === columnOf(chosen) + (by[1] ?? 0),
    );
    if (!next) return;
    event.preventDefault();
    onChoose(next);
    host.current?.querySelector<HTMLElement>(`[data-at="${next.kb} ${columnOf(next)}"]`)?.focus();
  };
  return (
    // biome-ignore lint/a11y/noStaticElementInteractions: the keys are those of the buttons inside
    <div class={css["matrix"]} ref={host} onKeyDown={walk}>
      <span class={css["matrix-head"]} />
      {[...Array(COLUMNS + 1).keys()].map((ke) => (
        <span key={ke} class={`${css["matrix-head"]} number`} aria-hidden="true">
          ke {ke}
        </span>
      ))}
      <span class={css["matrix-head"]} aria-hidden="true">
        super­posed
      </span>
      {rows.map((row, kb) => (
        <>
          <span key={`row ${kb + 1}`} class={`${css["matrix-side"]} number`} aria-hidden="true">
            kb {kb}
          </span>
          {row.map((one) => {
            const here = one.kb === chosen.kb && columnOf(one) === columnOf(chosen);
            return (
              <button
                key={`${kb} ${columnOf(one)}`}
                type="button"
                class={css["matrix-cell"]}
                style={{ "--column": String(columnOf(one) + 1) }}
                data-at={`${kb} ${columnOf(one)}`}
                aria-pressed={here}
                aria-label={cellWords(one)}
                tabIndex={here ? 0 : -1}
                onClick={() => onChoose(one)}
              >
                <Cell subject={subject} chosen={one} label={null} framed={!one.superposed && one.ke === kb} />
              </button>
            );
          })}
        </>
      ))}
    </div>
  );
}

interface CellProps {
  subject: Subject;
  chosen: Chosen;
  label: string | null;
  /** Marks the cell of this point. */
  point?: Point;
  /** Shows within which cell the shuffle stays. */
  framed?: boolean;
  onPick?: (at: Point) => void;
}

const SIDE = 128;
const SQUARE = { dimensions: 2, parts: 2 } as const;

/** One image, with marks. */
export function Cell({ subject, chosen, label, point, framed = false, onPick }: CellProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const { kb, ke, superposed } = chosen;
  const image = useMemo(() => shuffledImage(subject, kb, ke, superposed), [subject, kb, ke, superposed]);
  useLayoutEffect(() => {
    if (!canvas.current) return;
    canvas.current.width = image.side;
    canvas.current.height = image.side;
    const data = new ImageData(image.pixels, image.side, image.side);
    canvas.current.getContext("2d")?.putImageData(data, 0, 0);
  }, [image]);
  const frame = point ? codeOf(SQUARE, point, kb) : new Array<number>(kb).fill(0);
  return (
    <span class={`${css["shuffled"]} ${onPick ? pickedClass : ""}`} {...(onPick ? picking(onPick) : {})}>
      <canvas ref={canvas} {...pictured(label)} />
      <svg viewBox={`0 0 ${SIDE} ${SIDE}`} aria-hidden="true">
        {(framed || point) && <Outline subject={subject} code={frame} kind="frame" />}
        {point && <Outline subject={subject} code={codeOf(SQUARE, point, COLUMNS)} kind="mark" />}
      </svg>
    </span>
  );
}

/** The outline of a cell: a square, or the triangle of the gasket in it. */
export function Outline({
  subject,
  code,
  kind,
}: {
  subject: Subject;
  code: readonly number[];
  kind: "frame" | "mark" | "from";
}) {
  const { corner, side } = cellOf(SQUARE, code);
  const [x, y] = [(corner[0] ?? 0) * SIDE, (1 - (corner[1] ?? 0)) * SIDE];
  const size = side * SIDE;
  const d =
    subject === "square" ? `M${x} ${y}v${-size}h${size}v${size}z` : `M${x} ${y}v${-size}L${x + size} ${y}z`;
  return (
    <g class={`${css["outline"]} ${css[kind]}`}>
      <path class={css["halo"]} d={d} />
      <path d={d} />
    </g>
  );
}

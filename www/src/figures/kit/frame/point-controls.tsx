import { fixed } from "#format/numbers";
import { type Notation, spokenOf } from "../notation/tex";
import { SliderControl } from "./control";

type Pair = [number, number];

interface PointControlsProps {
  point: readonly [number, number, number?];
  /** What each of its numbers is; `name` where those who hear it need more than the label. */
  axes: readonly [Axis, Axis];
  range?: readonly [min: number, max: number];
  step?: number;
  /** What those who hear it are told of a number. */
  said?: (symbol: string, value: number) => string;
  onMove: (point: Pair) => void;
}

interface Axis {
  label: string;
  symbol: Notation;
  name?: string;
}

/** A slider for each number of a point, for keys and for those who would rather not aim. */
export function PointControls({
  point,
  axes,
  range = [0, 1],
  step = 0.01,
  said,
  onMove,
}: PointControlsProps) {
  return (
    <>
      {axes.map((axis, i) => {
        const value = point[i] ?? 0;
        const text = fixed(value, 3);
        return (
          <SliderControl
            key={axis.label}
            {...axis}
            {...{ range, step, value, text }}
            valueText={said?.(spokenOf(axis.symbol), value) ?? `${spokenOf(axis.symbol)} = ${text}`}
            onChange={(next) => onMove(i === 0 ? [next, point[1]] : [point[0], next])}
          />
        );
      })}
    </>
  );
}

/** Across and up, for a point of the plane. */
export function acrossAndUp(what: string): [Axis, Axis] {
  return [
    { label: `${what}, across`, symbol: "x" },
    { label: `${what}, up`, symbol: "y" },
  ];
}

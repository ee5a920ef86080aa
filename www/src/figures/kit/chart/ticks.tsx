import { formatNumber } from "#format/numbers";
import type { Size } from "#geometry/coordinates";
import { along, type Scale } from "./scale";

interface TicksProps {
  x: Scale;
  y: Scale;
  size: Size;
  /** The mark at a value of y: a line across, or a short one beside the axis. */
  mark: string;
  /** Pixels between the axes and their numbers. */
  gap: number;
}

/** The marks of both axes with their numbers. */
export function Ticks({ x, y, size, mark, gap }: TicksProps) {
  const text = (scale: Scale, value: number) => (scale.format ?? ((v: number) => formatNumber(v)))(value);
  return (
    <>
      {y.ticks.map((tick) => (
        <g key={tick} transform={`translate(0 ${(1 - along(y, tick)) * size.height})`}>
          <path d={mark} />
          <text x={-gap} dy="0.32em" text-anchor="end">
            {text(y, tick)}
          </text>
        </g>
      ))}
      {x.ticks.map((tick) => (
        <g key={tick} transform={`translate(${along(x, tick) * size.width} ${size.height})`}>
          <path d="M0 0V4" />
          <text y={gap + 9} text-anchor="middle">
            {text(x, tick)}
          </text>
        </g>
      ))}
    </>
  );
}

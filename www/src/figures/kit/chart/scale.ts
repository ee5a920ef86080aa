/** Where a value lies on an axis, and which values are worth a mark. */
export interface Scale {
  min: number;
  max: number;
  log?: boolean;
  ticks: readonly number[];
  format?: (value: number) => string;
}

/** From 0 to 1 in quarters: the moments of a morph. */
export const QUARTERS: Scale = { min: 0, max: 1, ticks: [0, 0.25, 0.5, 0.75, 1] };

/** 0 at `min`, 1 at `max`; values beyond lie beyond. */
export function along({ min, max, log = false }: Scale, value: number): number {
  if (log) return (Math.log(value) - Math.log(min)) / (Math.log(max) - Math.log(min));
  return (value - min) / (max - min);
}

/** A polyline through points of two scales, for a path in a box of the given size; what is not finite breaks it. */
export function linePath(
  points: readonly (readonly [number, number])[],
  x: Scale,
  y: Scale,
  size: { width: number; height: number },
): string {
  let open = false;
  let path = "";
  for (const [px, py] of points) {
    const left = along(x, px) * size.width;
    const top = (1 - along(y, py)) * size.height;
    if (Number.isFinite(left) && Number.isFinite(top)) {
      path += `${open ? "L" : "M"}${left.toFixed(1)} ${top.toFixed(1)}`;
      open = true;
    } else open = false;
  }
  return path;
}

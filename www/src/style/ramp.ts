/** Colours of the gap field: light where it holds together, then from mauve to navy as the gap widens. */

export type Rgb = readonly [r: number, g: number, b: number];

/** In one piece, proved. Far lighter than the rest, so that the border is seen without seeing hue. */
export const HOLDS: Rgb = [250, 245, 232];
/** Looks whole at the resolution: a shade deeper, and dotted with the next. */
export const TOUCHES: Rgb = [238, 231, 213];
export const TOUCHES_DOT: Rgb = [205, 195, 170];
/** In pieces, proved, by a gap that this resolution does not show: between the two, and striped with the next. */
export const HIDDEN: Rgb = [226, 213, 222];
export const HIDDEN_STRIPE: Rgb = [190, 166, 198];
/** Broken, where no size is shown. */
export const BROKEN: Rgb = [36, 31, 82];
export const NONE: Rgb = [118, 118, 124];
export const UNDECIDED: Rgb = [176, 172, 166];

/** Lightness falls all the way, for eyes and printers that know no hue. */
const STOPS: readonly (readonly [at: number, colour: Rgb])[] = [
  [0, [146, 108, 168]],
  [0.35, [92, 64, 130]],
  [0.7, [44, 36, 92]],
  [1, [15, 17, 44]],
];

/** The narrowest gap of the scale, relative to the size of the shape: what 600 pixels resolve. */
export const NARROWEST = 1 / 600;
/** The widest gap of the scale over the narrowest: at home, all of the shape. */
export const REACH = 600;

/** Where a relative gap lies on the scale, 0 to 1: by its logarithm, since narrow gaps are what matters. */
export function shadeOf(gap: number, narrowest = NARROWEST): number {
  if (!(gap > narrowest)) return 0;
  return Math.min(1, Math.log(gap / narrowest) / Math.log(REACH));
}

/** The colour at a place of the scale. */
export function ramp(shade: number): Rgb {
  const s = Math.min(1, Math.max(0, shade));
  const upper = Math.max(
    1,
    STOPS.findIndex(([at]) => at >= s),
  );
  const [s0, from] = STOPS[upper - 1] ?? [0, HOLDS];
  const [s1, to] = STOPS[upper] ?? [1, HOLDS];
  const k = (s - s0) / (s1 - s0);
  return mixed(from, to, k);
}

/** Part of the way from one colour to another. */
export function mixed(from: Rgb, to: Rgb, part: number): Rgb {
  const mix = (i: 0 | 1 | 2) => Math.round(from[i] + part * (to[i] - from[i]));
  return [mix(0), mix(1), mix(2)];
}

/** The scale as a CSS gradient, for a legend. */
export function gradient(): string {
  return `linear-gradient(to right, ${STOPS.map(([at, c]) => `rgb(${c.join(" ")}) ${100 * at}%`).join(", ")})`;
}

import "./slider-breaks.css";

/** Broken stretches of time, marked on its slider. */
export function SliderBreaks({ breaks }: { breaks: readonly (readonly [from: number, to: number])[] }) {
  return breaks.map(([from, to]) => (
    <span
      key={`${from}-${to}`}
      class="slider-break"
      style={{ left: `${100 * from}%`, width: `max(2px, ${100 * (to - from)}%)` }}
    />
  ));
}

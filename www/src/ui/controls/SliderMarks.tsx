import css from "./slider-marks.module.css";

/** A value that means something, `at` a part of the way. */
export function SliderMark({ at, title }: { at: number; title: string }) {
  return <span class={css["slider-mark"]} style={{ left: `${100 * at}%` }} title={title} />;
}

/** Broken stretches of time. */
export function SliderBreaks({ breaks }: { breaks: readonly (readonly [from: number, to: number])[] }) {
  return breaks.map(([from, to]) => (
    <span
      key={`${from}-${to}`}
      class={css["slider-break"]}
      style={{ left: `${100 * from}%`, width: `max(2px, ${100 * (to - from)}%)` }}
    />
  ));
}

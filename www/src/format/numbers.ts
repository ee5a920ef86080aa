/** Numbers as fields show them and step them. */
import * as messages from "./messages";

/** Digits as people type them, `-.5`, `0,25`, `1e-3`; null for all else, which may be a formula. */
export function plainNumber(text: string): number | null {
  const digits = text
    .trim()
    .replace(/^[−–]/, "-")
    .replace(/^([^,]*\d),(\d[^,]*)$/, "$1.$2");
  if (!/^[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?$/i.test(digits)) return null;
  const value = Number(digits);
  return Number.isFinite(value) ? value + 0 : null;
}

/** Says what is wrong with a number outside a range, or nothing. Both ends belong to the range. */
export function rangeProblem(value: number, min?: number, max?: number): string | undefined {
  if (min !== undefined && value < min) return messages.atLeast(formatNumber(min));
  if (max !== undefined && value > max) return messages.atMost(formatNumber(max));
  return undefined;
}

/** Shortest text with at most `digits` decimals, without trailing zeros, with a true minus sign. */
export function formatNumber(value: number, digits = 4): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  const text =
    size >= 1e6 || (size > 0 && size < 0.5 * 10 ** -digits)
      ? value.toExponential(2).replace("e+", "e")
      : value
          .toFixed(digits)
          .replace(/(\.\d*?)0+$/, "$1")
          .replace(/\.$/, "");
  return text.replace("-", "−");
}

/** Numbers that differ beyond these decimals differ by rounding. */
const MOST_DIGITS = 9;

/** So many decimals, at least `least`, that numbers which differ are seen to differ. */
export function digitsApart(values: readonly number[], least: number): number {
  const seen = (digits: number) => new Set(values.map((value) => formatNumber(value, digits))).size;
  const different = seen(MOST_DIGITS);
  let digits = least;
  while (digits < MOST_DIGITS && seen(digits) < different) digits++;
  return digits;
}

/** A fixed number of decimals, so that a readout does not dance while it changes. */
export function fixed(value: number, digits = 2): string {
  if (!Number.isFinite(value)) return "–";
  const text = value.toFixed(digits);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}

/** `value + step`, rounded to the decimals of the two, so that 0.1 + 0.2 is 0.3. */
export function addStep(value: number, step: number): number {
  const decimals = (x: number) => {
    const text = x.toExponential();
    const [mantissa = "", exponent = "0"] = text.split("e");
    return Math.max(0, (mantissa.split(".")[1] ?? "").length - Number(exponent));
  };
  const digits = Math.min(12, Math.max(decimals(value), decimals(step)));
  const sum = Number((value + step).toFixed(digits));
  return sum === 0 ? 0 : sum;
}

/** How far one key press moves a value: shift is finer by ten, alt coarser by ten. Null for other keys. */
export function keyStep(
  event: { key: string; shiftKey: boolean; altKey: boolean },
  step: number,
): number | null {
  const scale = event.shiftKey ? 0.1 : event.altKey ? 10 : 1;
  switch (event.key) {
    case "ArrowUp":
    case "ArrowRight":
      return step * scale;
    case "ArrowDown":
    case "ArrowLeft":
      return -step * scale;
    case "PageUp":
      return step * 10;
    case "PageDown":
      return -step * 10;
    default:
      return null;
  }
}

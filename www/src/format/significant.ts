const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** As many digits as are asked for, whatever the size: 12300, 0.00123, 1.23×10⁹; with a true minus sign. */
export function significant(value: number, digits = 3): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const [mantissa = "", power = "0"] = value.toExponential(digits - 1).split("e");
  const exponent = Number(power);
  if (exponent >= -4 && exponent < 6) return plain(`${Number(`${mantissa}e${power}`)}`);
  const raised = [...`${Math.abs(exponent)}`].map((digit) => RAISED[Number(digit)]).join("");
  return `${plain(`${Number(mantissa)}`)}×10${exponent < 0 ? "⁻" : ""}${raised}`;
}

function plain(text: string): string {
  return text.replace("-", "−");
}

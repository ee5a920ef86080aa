/**
 * What a page may set a property of the element to, as the text of its attribute. Frameworks write the property where
 * there is one: with a string, a number, a boolean, or whatever the page computes with.
 */

/** Of an attribute that is there or not: `controls="false"` is off, since frameworks write that. */
export function isOn(text: string | null): boolean {
  return text !== null && text.trim().toLowerCase() !== "false";
}

/** Whether what a property was set to switches it on. An empty string is what stands in the attribute `controls`. */
export function meansOn(value: unknown): boolean {
  if (typeof value === "string") return isOn(value);
  return value !== null && value !== undefined && value !== false && value !== 0 && !Number.isNaN(value);
}

/** Null takes the attribute away. */
export function textOf(value: unknown): string | null {
  return value === null || value === undefined || value === false ? null : String(value);
}

/** Rows of numbers as well, in arrays of any kind. */
export function mapsTextOf(value: unknown): string | null {
  return typeof value === "object" && value !== null ? jsonOf(value) : textOf(value);
}

/** Points as well: [[u, v], ..]. */
export function pathTextOf(value: unknown): string | null {
  if (typeof value !== "object" || value === null) return textOf(value);
  if (!Array.isArray(value)) return jsonOf(value);
  return value.length > 0 ? value.map(String).join(";") : "straight";
}

function jsonOf(value: object): string {
  try {
    return JSON.stringify(value, (_, inner) =>
      ArrayBuffer.isView(inner) && !(inner instanceof DataView)
        ? Array.from(inner as unknown as ArrayLike<number>)
        : inner,
    );
  } catch {
    return String(value);
  }
}

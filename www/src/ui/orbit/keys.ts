/** What a key asks of a point that is followed: a map by its number, or one step back. */
export type OrbitKey = number | "back";

export function orbitKey(event: KeyboardEvent, maps: number): OrbitKey | null {
  if (event.ctrlKey || event.metaKey || event.altKey) return null;
  if (event.target instanceof Element && event.target.closest("input:not([type=radio]), select, textarea"))
    return null;
  if (event.key === "Backspace") return "back";
  const letter = /^[1-9]$/.test(event.key) ? Number(event.key) - 1 : -1;
  return letter >= 0 && letter < maps ? letter : null;
}

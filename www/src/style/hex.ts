/** Red, green and blue of "#rrggbb", 0 to 255. */
export function channelsOf(colour: string): number[] {
  const all = Number.parseInt(colour.slice(1), 16) || 0;
  return [(all >> 16) & 255, (all >> 8) & 255, all & 255];
}

/** "#rrggbb" of red, green and blue. */
export function hexOf(channels: readonly number[]): string {
  const two = (x: number) =>
    Math.min(255, Math.max(0, Math.round(x)))
      .toString(16)
      .padStart(2, "0");
  return `#${channels.map(two).join("")}`;
}

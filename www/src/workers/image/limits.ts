/** The most pixels that are decoded. */
export const MOST_MEGAPIXELS = 64;

/** "10,000 × 5,000 pixels, 50 megapixels" */
export function inWords({ width, height }: { width: number; height: number }): string {
  const side = (pixels: number) => pixels.toLocaleString("en-GB");
  return `${side(width)} × ${side(height)} pixels, ${Math.round((width * height) / 1e6)} megapixels`;
}

/** A name that fits a line. */
export function shortName(name: string, otherwise: string): string {
  const plain = name.trim() || otherwise;
  return plain.length > 40 ? `${plain.slice(0, 24)}…${plain.slice(-12)}` : plain;
}

import { spaceTask } from "./client";
import type { PictureRequest, Relief, ReliefRequest, Rows } from "./picture";

/** The workers of the stage: what one of them makes, they make side by side. */
const LANES = [0, 4] as const;

/** As many bands of rows, each of them as high as the others, and of whole pixels of `factor` rows. */
export function bandsOf(height: number, factor: number, count: number): Rows[] {
  const bands = Math.max(1, Math.min(count, height));
  const border = (band: number) => Math.round((band * height) / bands) * factor;
  return Array.from({ length: bands }, (_, band): Rows => [border(band), border(band + 1)]);
}

/** As many as there are cores for. */
const hands = () => LANES.slice(0, Math.max(1, navigator.hardwareConcurrency || 1));

export interface Banded {
  image: ImageData;
  /** Which pieces are seen, pixel by pixel of what was carved; null unless asked for. */
  codes: Uint32Array<ArrayBuffer> | null;
}

/**
 * A complete picture by all workers of the stage; `reach` says how far hollows are looked for, 1 in a picture that has
 * as many pixels as it is to have in the end. Rejected with `{ code: "stopped" }` when called off.
 */
export async function pictureInBands(
  request: PictureRequest,
  { reach, codes = false, signal }: { reach: number; codes?: boolean; signal: AbortSignal },
): Promise<Banded> {
  const { width, height, factor } = request;
  const lanes = hands();
  const bands = bandsOf(height, factor, lanes.length);
  const made = await Promise.all(
    bands.map((rows, i) =>
      spaceTask("band", { ...request, rows, reach, codes }, { signal, lane: lanes[i] ?? 0 }),
    ),
  );
  const image = new ImageData(width, height);
  const seen = codes ? new Uint32Array(width * height * factor * factor) : null;
  for (const [i, { data, codes: here }] of made.entries()) {
    const from = bands[i]?.[0] ?? 0;
    image.data.set(data, (from / factor) * width * 4);
    if (here) seen?.set(here, from * width * factor);
  }
  return { image, codes: seen };
}

/** The same before it is coloured. */
export async function reliefInBands(
  request: ReliefRequest,
  options: { signal: AbortSignal },
): Promise<Relief> {
  const { width, height } = request;
  const lanes = hands();
  const bands = bandsOf(height, 1, lanes.length);
  const [first, ...others] = await Promise.all(
    bands.map((rows, i) => spaceTask("relief", { ...request, rows }, { ...options, lane: lanes[i] ?? 0 })),
  );
  if (first && others.length === 0) return first;
  const parts = first ? [first, ...others] : others;
  const depth = new Float32Array(width * height);
  const codes = new Uint32Array(width * height);
  for (const [i, part] of parts.entries()) {
    const at = (bands[i]?.[0] ?? 0) * width;
    depth.set(part.depth, at);
    codes.set(part.codes, at);
  }
  return { width, height, depth, codes, empty: parts.every(({ empty }) => empty) };
}

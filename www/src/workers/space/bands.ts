import { spaceTask } from "./client";
import type { LampRequest, PictureRequest, Relief, ReliefRequest, Rows } from "./picture";

/** The workers of the stage: what one of them makes, they make side by side. */
const LANES = [0, 4] as const;

/** As many bands of rows, each of them as high as the others, and of whole pixels of `factor` rows. */
export function bandsOf(height: number, factor: number, count: number): Rows[] {
  const bands = Math.max(1, Math.min(count, height));
  const border = (band: number) => Math.round((band * height) / bands) * factor;
  return Array.from({ length: bands }, (_, band): Rows => [border(band), border(band + 1)]);
}

/** Bands a worker of a picture at rest: where most is to be seen one takes longer, and others go on meanwhile. */
const BANDS_AT_REST = 3;

/** Has bands made by as many workers as there are cores for, each the next one that nobody has taken. */
async function byAll<T>(
  rows: { height: number; factor: number; atRest: boolean },
  make: (rows: Rows, lane: 0 | 4) => Promise<T>,
): Promise<{ from: number; made: T }[]> {
  const lanes = LANES.slice(0, Math.max(1, navigator.hardwareConcurrency || 1));
  const bands = bandsOf(rows.height, rows.factor, lanes.length * (rows.atRest ? BANDS_AT_REST : 1));
  const made: { from: number; made: T }[] = [];
  let next = 0;
  const work = async (lane: 0 | 4) => {
    for (let band = bands[next++]; band; band = bands[next++])
      made.push({ from: band[0], made: await make(band, lane) });
  };
  await Promise.all(lanes.map(work));
  return made;
}

export interface Banded {
  image: ImageData;
  /** Which pieces are seen, pixel by pixel of what was carved; null unless asked for. */
  codes: Uint32Array<ArrayBuffer> | null;
}

/**
 * A complete picture by all workers of the stage; `reach` says how far hollows are looked for, 1 in a picture that has
 * as many pixels as it is to have in the end. One `atRest` is none of many that follow each other. Rejected with
 * `{ code: "stopped" }` when called off.
 */
export async function pictureInBands(
  request: PictureRequest,
  options: { reach: number; codes?: boolean; atRest: boolean; signal: AbortSignal },
): Promise<Banded> {
  const { width, height, factor } = request;
  const { reach, codes = false, atRest, signal } = options;
  const bands = await byAll({ height, factor, atRest }, (rows, lane) =>
    spaceTask("band", { ...request, rows, reach, codes }, { signal, lane }),
  );
  const image = new ImageData(width, height);
  const seen = codes ? new Uint32Array(width * height * factor * factor) : null;
  for (const { from, made } of bands) {
    image.data.set(made.data, (from / factor) * width * 4);
    if (made.codes) seen?.set(made.codes, from * width * factor);
  }
  return { image, codes: seen };
}

/** The same at rest, before it is coloured. */
export async function reliefInBands(
  request: ReliefRequest,
  { signal }: { signal: AbortSignal },
): Promise<Relief> {
  const { width, height } = request;
  const bands = await byAll({ height, factor: 1, atRest: true }, (rows, lane) =>
    spaceTask("relief", { ...request, rows }, { signal, lane }),
  );
  const depth = new Float32Array(width * height);
  const codes = new Uint32Array(width * height);
  for (const { from, made } of bands) {
    depth.set(made.depth, from * width);
    codes.set(made.codes, from * width);
  }
  return { width, height, depth, codes, empty: bands.every(({ made }) => made.empty) };
}

/** What the lamp of a picture sees, which is so many pixels wide and high. */
export async function lampInBands(
  request: Omit<LampRequest, "rows">,
  side: number,
  { signal }: { signal: AbortSignal },
): Promise<Float32Array<ArrayBuffer>> {
  const bands = await byAll({ height: side, factor: 1, atRest: true }, (rows, lane) =>
    spaceTask("lamp", { ...request, rows }, { signal, lane }),
  );
  const depth = new Float32Array(side * side);
  for (const { from, made } of bands) depth.set(made, from * side);
  return depth;
}

/**
 * Lights what was carved before. `lamp` is what its lamp sees, nothing where no shadows are cast, and `around` says on
 * how many rows above and below the light of one hangs.
 */
export async function litInBands(
  request: PictureRequest,
  { depth, codes }: Relief,
  options: { lamp: Float32Array<ArrayBuffer>; reach: number; around: number; signal: AbortSignal },
): Promise<ImageData> {
  const { width, height, factor } = request;
  const { lamp, reach, around, signal } = options;
  const across = width * factor;
  const bands = await byAll({ height, factor, atRest: true }, (rows, lane) => {
    const top = Math.max(0, rows[0] - around);
    const part = [top * across, Math.min(height * factor, rows[1] + around) * across] as const;
    const cut = { top, depth: depth.slice(...part), codes: codes.slice(...part) };
    return spaceTask("lit", { ...request, ...cut, rows, lamp, reach }, { signal, lane });
  });
  const image = new ImageData(width, height);
  for (const { from, made } of bands) image.data.set(made, (from / factor) * width * 4);
  return image;
}

/** Photographs and masks as pixels, where there is no browser that decodes them. */
import { readHeader } from "#workers/image/header";
import { inWords, MOST_MEGAPIXELS } from "#workers/image/limits";
import { otherWords } from "#workers/image/signature";
import { isWhole } from "#workers/image/whole";
import { Refusal } from "../options";

/** The most pixels that are worked on. */
const MOST_PIXELS = 1 << 22;
/** Megabytes that the decoder of JPEG may take. */
const MOST_MEGABYTES = 2048;

export interface Picture {
  width: number;
  height: number;
  /** Red, green, blue and alpha, row after row from the top. */
  pixels: Uint8Array;
  /** As it is in the file, upright. */
  original: { width: number; height: number };
}

/** Null where a file is no picture, but perhaps a text. */
export async function pictureIn(bytes: Uint8Array, named: string): Promise<Picture | null> {
  const header = readHeader(bytes);
  if (header.other !== undefined) throw new Refusal(`${named} is ${otherWords(header.other)}`);
  if (header.kind === "svg" || header.kind === "unknown") return null;
  if (header.kind !== "png" && header.kind !== "jpeg")
    throw new Refusal(`${named} is a ${header.kind.toUpperCase()} picture: save it as PNG or JPEG.`);
  const damaged = new Refusal(`${named} is damaged or ends too soon. Save or copy it again.`);
  if (!header.size || !isWhole(header.kind, bytes)) throw damaged;
  if (header.size.width * header.size.height > MOST_MEGAPIXELS * 1e6)
    throw new Refusal(
      `${named} has ${inWords(header.size)}, and at most ${MOST_MEGAPIXELS} are read. Make it smaller first.`,
    );
  let decoded: Raster;
  try {
    decoded = header.kind === "png" ? await png(bytes) : await jpeg(bytes);
  } catch {
    throw damaged;
  }
  const { width, height } = decoded;
  return { ...smaller(decoded, MOST_PIXELS), original: { width, height } };
}

type Raster = Pick<Picture, "width" | "height" | "pixels">;

async function jpeg(bytes: Uint8Array): Promise<Raster> {
  const { default: decode } = await import("jpeg-js/lib/decoder.js");
  const { width, height, data } = decode(bytes, {
    useTArray: true,
    formatAsRGBA: true,
    maxResolutionInMP: MOST_MEGAPIXELS + 1,
    maxMemoryUsageInMB: MOST_MEGABYTES,
  });
  return upright({ width, height, pixels: data }, orientationOf(bytes));
}

async function png(bytes: Uint8Array): Promise<Raster> {
  const { decode } = await import("fast-png");
  const { width, height, data, depth, channels, palette, transparency } = decode(bytes);
  const pixels = new Uint8Array(4 * width * height);
  // Samples of less than a byte lie side by side, and each row begins with a new byte.
  const perRow = depth < 8 ? Math.ceil((width * channels * depth) / 8) : width * channels;
  const most = 2 ** depth - 1;
  const sample = (x: number, y: number, channel: number): number => {
    const at = x * channels + channel;
    if (depth >= 8) return data[y * perRow + at] ?? 0;
    const byte = data[y * perRow + ((at * depth) >> 3)] ?? 0;
    return (byte >> (8 - depth - ((at * depth) & 7))) & most;
  };
  const byte = (value: number) => Math.round((255 * value) / most);
  // One colour may stand for what is clear.
  const clear = transparency && transparency.length > 0 && channels % 2 === 1 ? transparency : null;
  for (let y = 0, i = 0; y < height; y++) {
    for (let x = 0; x < width; x++, i += 4) {
      const first = sample(x, y, 0);
      if (palette) {
        const [red = 0, green = 0, blue = 0, alpha = 255] = palette[first] ?? [];
        pixels.set([red, green, blue, alpha], i);
        continue;
      }
      const [green, blue] = channels < 3 ? [first, first] : [sample(x, y, 1), sample(x, y, 2)];
      pixels[i] = byte(first);
      pixels[i + 1] = byte(green);
      pixels[i + 2] = byte(blue);
      const hidden = clear && [first, green, blue].every((value, k) => value === (clear[k] ?? clear[0]));
      pixels[i + 3] = hidden ? 0 : channels % 2 === 0 ? byte(sample(x, y, channels - 1)) : 255;
    }
  }
  return { width, height, pixels };
}

/**
 * How a camera was held, 1 to 8, as Exif says it (JEITA CP-3451, tag 0x0112); 1 where it does not. Values 5 to 8 lie
 * on their side.
 */
export function orientationOf(bytes: Uint8Array): number {
  const data = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  for (let at = 2; at + 4 <= bytes.length && bytes[at] === 0xff && bytes[at + 1] !== 0xda; ) {
    const length = data.getUint16(at + 2);
    const head = at + 10;
    if (
      bytes[at + 1] === 0xe1 &&
      length >= 16 &&
      at + 2 + length <= bytes.length &&
      data.getUint32(at + 4) === EXIF
    )
      return tagIn(new DataView(data.buffer, data.byteOffset + head, length - 8));
    at += 2 + Math.max(2, length);
  }
  return 1;
}

/** "Exif" */
const EXIF = 0x45786966;

function tagIn(data: DataView): number {
  const small = data.byteLength >= 8 && data.getUint16(0) === 0x4949;
  if (data.byteLength < 8) return 1;
  const from = data.getUint32(4, small);
  if (from + 2 > data.byteLength) return 1;
  const count = data.getUint16(from, small);
  for (let i = 0; i < count && from + 2 + 12 * (i + 1) <= data.byteLength; i++) {
    const at = from + 2 + 12 * i;
    if (data.getUint16(at, small) !== 0x0112) continue;
    const value = data.getUint16(at + 8, small);
    return value >= 1 && value <= 8 ? value : 1;
  }
  return 1;
}

/** A picture as it was seen. */
export function upright({ width, height, pixels }: Raster, orientation: number): Raster {
  if (orientation === 1) return { width, height, pixels };
  const size = orientation >= 5 ? { width: height, height: width } : { width, height };
  // Which way its columns and rows run in the file.
  const leftward = [2, 3, 7, 8].includes(orientation);
  const upward = [3, 4, 6, 7].includes(orientation);
  const from = new Uint32Array(pixels.buffer, pixels.byteOffset, width * height);
  const made = new Uint32Array(width * height);
  for (let y = 0; y < size.height; y++) {
    for (let x = 0; x < size.width; x++) {
      const [p, q] = orientation >= 5 ? [y, x] : [x, y];
      const [column, row] = [leftward ? width - 1 - p : p, upward ? height - 1 - q : q];
      made[y * size.width + x] = from[row * width + column] as number;
    }
  }
  return { ...size, pixels: new Uint8Array(made.buffer) };
}

/** A picture of at most so many pixels, each the mean of a block of those that there were. */
export function smaller(picture: Raster, most: number): Raster {
  const { width, height, pixels } = picture;
  const by = Math.ceil(Math.sqrt((width * height) / most));
  if (by <= 1) return picture;
  const size = { width: Math.max(1, Math.floor(width / by)), height: Math.max(1, Math.floor(height / by)) };
  const made = new Uint8Array(4 * size.width * size.height);
  for (let y = 0; y < size.height; y++) {
    const rows = Math.min(by, height - y * by);
    for (let x = 0; x < size.width; x++) {
      const columns = Math.min(by, width - x * by);
      const sums = [0, 0, 0, 0];
      for (let k = 0; k < rows * columns; k++) {
        const at = 4 * ((y * by + Math.floor(k / columns)) * width + x * by + (k % columns));
        for (let c = 0; c < 4; c++) sums[c] = (sums[c] ?? 0) + (pixels[at + c] as number);
      }
      for (let c = 0; c < 4; c++)
        made[4 * (y * size.width + x) + c] = Math.round((sums[c] ?? 0) / (rows * columns));
    }
  }
  return { ...size, pixels: made };
}

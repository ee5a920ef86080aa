/** The texts of QR codes in a picture: by the browser's own reader where there is one, else by a library. */
import { decodeQR, decodeQRBatch } from "qr/decode.js";

/** What reads codes in some browsers; TypeScript does not know it yet. */
interface Detector {
  detect(picture: ImageBitmap): Promise<readonly { rawValue: string }[]>;
}
interface DetectorClass {
  new (options: { formats: readonly string[] }): Detector;
  getSupportedFormats(): Promise<readonly string[]>;
}

/** How a picture is looked at: a frame of a film, of which the next comes at once, or with patience. */
export type Care = "frame" | "picture";

/** Longer sides are made shorter: codes are read from fewer pixels, and photographs have many. */
const SIDES = { frame: [900], picture: [1600, 800, 2600] } as const;
/** So long, in milliseconds, the library may try again. */
const TIME = { frame: 60, picture: 1500 } as const;

let detector: Promise<Detector | null> | null = null;

async function ownDetector(): Promise<Detector | null> {
  const Own = (globalThis as { BarcodeDetector?: DetectorClass }).BarcodeDetector;
  if (!Own) return null;
  try {
    return (await Own.getSupportedFormats()).includes("qr_code") ? new Own({ formats: ["qr_code"] }) : null;
  } catch {
    return null;
  }
}

/** All texts that are found; none where there is no code that can be read. */
export async function textsIn(picture: ImageBitmap, care: Care): Promise<string[]> {
  detector ??= ownDetector();
  const own = await detector;
  if (own) {
    try {
      const texts = (await own.detect(picture)).map(({ rawValue }) => rawValue).filter((text) => text !== "");
      if (texts.length > 0 || care === "frame") return texts;
    } catch {
      // Some systems say that they can, and cannot.
      detector = Promise.resolve(null);
    }
  }
  const longest = Math.max(picture.width, picture.height);
  for (const side of SIDES[care]) {
    const scale = Math.min(1, side / longest);
    const texts = await read(pixels(picture, scale), care);
    // The pixels of a small picture are no others the next time.
    if (texts.length > 0 || longest <= Math.min(...SIDES[care])) return texts;
  }
  return [];
}

async function read(data: ImageData, care: Care): Promise<string[]> {
  const { width, height } = data;
  const image = { width, height, data: data.data };
  try {
    if (care === "frame") return [decodeQR(image, { timeLimit: TIME.frame })];
    const [results = []] = await decodeQRBatch([image], { timeLimit: TIME.picture });
    return results.filter((one): one is string => typeof one === "string");
  } catch {
    return [];
  }
}

function pixels(picture: ImageBitmap, scale: number): ImageData {
  const width = Math.max(1, Math.round(picture.width * scale));
  const height = Math.max(1, Math.round(picture.height * scale));
  const context = new OffscreenCanvas(width, height).getContext("2d", { willReadFrequently: true });
  if (!context) throw new Error("no canvas");
  context.drawImage(picture, 0, 0, width, height);
  return context.getImageData(0, 0, width, height);
}

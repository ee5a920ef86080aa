/** Gives somebody a file. */
import * as messages from "../messages";

export function download(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  downloadFrom(url, name);
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

/** The same of what is kept under an address. */
export function downloadFrom(url: string, name: string): void {
  const anchor = document.createElement("a");
  anchor.href = url;
  anchor.download = name;
  anchor.click();
}

/** A name as a part of a file's name: letters and digits, at most so many. */
export function plainName(name: string, otherwise: string, most = 40): string {
  const letters = name
    .normalize()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]+/gu, "-")
    .replace(/^-|-$/g, "");
  const plain = [...letters].slice(0, most).join("");
  return plain || otherwise;
}

/** A canvas as the bytes of a PNG. */
export function pngOf(canvas: HTMLCanvasElement): Promise<Blob> {
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) resolve(blob);
      else reject(new Error(messages.browserCouldNotEncode));
    }, "image/png");
  });
}

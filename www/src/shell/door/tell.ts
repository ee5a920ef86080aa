/** What a file is, by what is in it: its name may say anything. */

/**
 * `picture`: made of pixels. `outline`: a drawing, places, or a table of one or two columns. `maps`: systems, or a
 * document. `animation`: of space.
 */
export type FileKind = "picture" | "outline" | "maps" | "animation" | "empty" | "other";

/** As much of a file as is looked at. */
export const HEAD_BYTES = 64 << 10;

const PICTURES = ["\x89PNG\r\n", "\xff\xd8\xff", "GIF8", "RIFF....WEBP", "....ftypavi", "BM....\0\0\0\0"];

/** What steers old machines is in no text, but for tabs and ends of lines, pages and files. */
// biome-ignore lint/suspicious/noControlCharactersInRegex: these are what is looked for
const NO_TEXT = /[\x00-\x08\x0b\x0e-\x19\x1b-\x1f]/;

function isPicture(bytes: string): boolean {
  return PICTURES.some((magic) => [...magic].every((sign, i) => sign === "." || bytes[i] === sign));
}

/** Tells by the first bytes. */
export function tellFile(head: Uint8Array): FileKind {
  const bytes = String.fromCharCode(...head.subarray(0, 16));
  if (isPicture(bytes)) return "picture";
  const wide = bytes.startsWith("\xff\xfe")
    ? "utf-16le"
    : bytes.startsWith("\xfe\xff")
      ? "utf-16be"
      : "utf-8";
  const text = new TextDecoder(wide).decode(head.subarray(0, HEAD_BYTES)).trim();
  if (text === "") return "empty";
  if (NO_TEXT.test(text)) return "other";
  if (text.startsWith("<")) return ofXml(text);
  if (/^\[|^\{\s*["}]/.test(text)) return ofJson(text);
  // Blocks of IFStile begin with @, entries of Fractint stand in braces.
  if (/^\s*(@|\$dim)/m.test(text) || /^[^;\n]*[{}]/m.test(text)) return "maps";
  return ofTable(text);
}

/** Whether a picture says in its beginning that Frond saved it. */
export function mayHoldLink(head: Uint8Array): boolean {
  return new TextDecoder("latin1").decode(head.subarray(0, HEAD_BYTES)).includes("iTXtFrond link");
}

function ofXml(text: string): FileKind {
  if (/<(\w+:)?svg/.test(text)) return "outline";
  return /<(flames?|jwf-flame)\b/i.test(text) ? "maps" : "other";
}

function ofJson(text: string): FileKind {
  if (/"frond"\s*:\s*"space"/.test(text) || /"(packed|frames)"\s*:/.test(text.slice(0, 4096)))
    return "animation";
  if (/"(maps|systems|path)"\s*:/.test(text)) return "maps";
  // Rows of six numbers or more are maps, and pairs are points.
  const row = /\[\s*(-?[\d.][^[\]{}"]*)\]/.exec(text)?.[1];
  return text.startsWith("[") && row !== undefined && row.split(",").length >= 6 ? "maps" : "outline";
}

/** Numbers a line: one or two are points, six or more maps. */
function ofTable(text: string): FileKind {
  for (const line of text.split(/\r?\n|\r/)) {
    if (/^\s*[#;%/]/.test(line)) continue;
    // A comma within a number is counted as none where semicolons or tabs part.
    const words = line.split(/[;\t]/.test(line) ? /[;\t]\s*/ : /[\s,]+/).filter((word) => word.trim() !== "");
    if (words.length > 0 && words.every((word) => /^\s*[-+]?[\d.][\d.,eE+-]*\s*$/.test(word)))
      return words.length >= 6 ? "maps" : "outline";
  }
  // The signs of remarks in files of maps: what follows is farther on than is looked at.
  if (text.startsWith(";")) return "maps";
  // Whoever reads outlines says best what is missing.
  return "outline";
}

/** What a file is by its first bytes, whatever its name says: `crate/fit/src/read/sniff.rs` has the same list. */

/** Pictures that browsers decode. */
export type PictureKind = "png" | "jpeg" | "webp" | "gif" | "avif" | "bmp";

/** A picture, or the name of something that is neither a picture nor a text that Frond reads. */
export type Signature = { picture: PictureKind } | { other: string };

/** In an archive the names of what is in it are looked for in as many bytes. */
const ARCHIVE_BYTES = 64 << 10;

const PICTURES: readonly [magic: string, kind: PictureKind][] = [
  ["\x89PNG\r\n\x1a\n", "png"],
  ["\xff\xd8\xff", "jpeg"],
  ["GIF8", "gif"],
  ["RIFF....WEBP", "webp"],
  ["BM....\0\0\0\0", "bmp"],
];

/** A point stands for any byte. */
const OTHERS: readonly [magic: string, name: string][] = [
  ["II*\0", "TIFF picture"],
  ["MM\0*", "TIFF picture"],
  ["II+\0", "TIFF picture"],
  ["MM\0+", "TIFF picture"],
  ["\xff\x0a", "JPEG XL picture"],
  ["....JXL \r\n", "JPEG XL picture"],
  ["....jP  \r\n", "JPEG 2000 picture"],
  ["8BPS", "Photoshop picture"],
  ["%PDF", "PDF"],
  ["%!PS", "PostScript file"],
  ["\xc5\xd0\xd3\xc6", "PostScript file"],
  ["\xd0\xcf\x11\xe0", "spreadsheet or document of an old kind"],
  ["{\\rtf", "text with formatting (RTF)"],
  ["\x1f\x8b", "packed file (gzip)"],
  ["7z\xbc\xaf", "packed file (7z)"],
  ["Rar!", "packed file (RAR)"],
  ["\0\0'\x0a", "shapefile"],
  ["SQLite format 3", "database"],
  ["....ftyp", "film"],
  ["\x1aE\xdf\xa3", "film"],
  ["\0asm", "program"],
  ["\x7fELF", "program"],
  ["MZ\x90", "program"],
];

const ARCHIVES: readonly [part: string, name: string][] = [
  ["xl/", "spreadsheet (xlsx)"],
  ["word/", "document (docx)"],
  ["ppt/", "presentation (pptx)"],
  ["opendocument.spreadsheet", "spreadsheet (ods)"],
  ["opendocument.text", "document (odt)"],
  ["doc.kml", "map (KMZ)"],
];

/** What the first bytes say; null of a text, and of what is not known. */
export function signatureOf(bytes: Uint8Array): Signature | null {
  const head = String.fromCharCode(...bytes.subarray(0, 64));
  const begins = (magic: string) => [...magic].every((sign, i) => sign === "." || head[i] === sign);
  const picture = PICTURES.find(([magic]) => begins(magic));
  if (picture) return { picture: picture[1] };
  if (begins("....ftyp")) {
    // The brands of a container: its own, a version, and those that it can be read as.
    const brands = head.slice(8).match(/[\s\S]{4}/g) ?? [];
    if (brands.some((brand) => /^avi[fs]$/.test(brand))) return { picture: "avif" };
    if (brands.some((brand) => /^(hei[cxms]|mif1|msf1|hev[cx])$/.test(brand)))
      return { other: "HEIC picture" };
  }
  if (begins("PK\x03\x04")) {
    const text = new TextDecoder("latin1").decode(bytes.subarray(0, ARCHIVE_BYTES));
    return { other: ARCHIVES.find(([part]) => text.includes(part))?.[1] ?? "ZIP archive" };
  }
  const other = OTHERS.find(([magic]) => begins(magic));
  return other ? { other: other[1] } : null;
}

/** What to do with a file of another kind; `crate/fit/src/read/problem.rs` says the same. */
function adviceFor(name: string): string {
  if (name.startsWith("HEIC")) {
    return "Save it as JPEG and open that: on a phone, share it as “Most compatible”.";
  }
  if (name === "PDF" || name.startsWith("PostScript")) {
    return "Save a drawing in it as SVG, a photograph as JPEG, and a table as CSV, and open that.";
  }
  if (name.startsWith("Photoshop")) return "Save it as PNG or JPEG and open that.";
  if (/^(shapefile|database|map)/.test(name)) return "Save its layer as GeoJSON and open that.";
  if (name === "film") return "Save one picture of it as JPEG and open that.";
  if (name.endsWith("picture")) return "Save it as JPEG or PNG and open that.";
  if (name.startsWith("spreadsheet")) return "Save its sheet as CSV and open that.";
  if (/^(document|text)/.test(name)) {
    return "Save a table in it as plain text or CSV, and a picture as JPEG, and open that.";
  }
  if (name.startsWith("presentation")) return "Save its picture as SVG or JPEG and open that.";
  if (/archive|^packed/.test(name)) return "Unpack it and open what is in it.";
  return "";
}

/** A sentence or two on a file whose kind is known and not read: `a HEIC picture. Save it as JPEG ..`. */
export function otherWords(name: string): string {
  return `a ${name}. ${adviceFor(name)}`.trim();
}

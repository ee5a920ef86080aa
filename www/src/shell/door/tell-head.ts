/** The beginning of a text: how its letters are written, and what stands before it begins in earnest. */

import { signatureOf } from "#workers/image/signature";

/** As many bytes are looked at to find out whether a text without a mark is UTF-16. */
const SAMPLED_BYTES = 1024;
/** As much of a file is looked at first, and at most, to find where it begins. */
const FIRST_BYTES = 64 << 10;
const MOST_BYTES = 64 << 20;

const MARKS: readonly [mark: readonly number[], label: string][] = [
  [[0xff, 0xfe], "utf-16le"],
  [[0xfe, 0xff], "utf-16be"],
];

/** UTF-16 without a mark is known by the zeros in it: three quarters of the odd bytes, or of the even. */
function encodingOf(bytes: Uint8Array): string {
  for (const [mark, label] of MARKS) if (mark.every((byte, i) => bytes[i] === byte)) return label;
  const zeros = [0, 0] as [number, number];
  const pairs = Math.min(bytes.length, SAMPLED_BYTES) >> 1;
  for (let i = 0; i < 2 * pairs; i++) if (bytes[i] === 0) zeros[i % 2 === 0 ? 0 : 1]++;
  const many = (count: number) => pairs > 1 && 4 * count >= 3 * pairs;
  if (zeros[0] === 0 && many(zeros[1])) return "utf-16le";
  if (zeros[1] === 0 && many(zeros[0])) return "utf-16be";
  return "utf-8";
}

/** Bytes as text, without what ends a text on old machines. A letter that is cut at the end is left out. */
export function decoded(bytes: Uint8Array): string {
  const encoding = encodingOf(bytes);
  let text: string;
  try {
    text = new TextDecoder(encoding, { fatal: encoding === "utf-8" }).decode(bytes, { stream: true });
  } catch {
    text = new TextDecoder("windows-1252").decode(bytes);
  }
  let end = text.length;
  while (end > 0 && isEnd(text.charCodeAt(end - 1))) end--;
  return text.slice(0, end);
}

/** Blanks, and 0 and 0x1A, which old machines put at the end. */
const isEnd = (code: number) => code <= 0x20 && [0, 9, 10, 12, 13, 0x1a, 0x20].includes(code);

/**
 * What follows blanks, and of XML what follows the remarks, declarations and document type before its root; empty where
 * one of them does not end.
 */
export function pastBlanks(text: string): string {
  let rest = text.replace(/^[\s\u200b]+/, "");
  while (/^<[?!]/.test(rest)) {
    const end = rest.startsWith("<!--")
      ? after(rest, "-->", 4)
      : rest.startsWith("<?")
        ? after(rest, "?>")
        : typeEnd(rest);
    if (end === null) return "";
    rest = rest.slice(end).trimStart();
  }
  return rest;
}

function after(text: string, sign: string, from = 0): number | null {
  const at = text.indexOf(sign, from);
  return at < 0 ? null : at + sign.length;
}

/** Where a document type ends: it may have declarations in brackets, with remarks and quoted texts. */
function typeEnd(text: string): number | null {
  const parts = /<!--[\s\S]*?-->|"[^"]*"|'[^']*'|[[\]>]|<!--|["']/g;
  parts.lastIndex = 2;
  let inside = false;
  for (let found = parts.exec(text); found; found = parts.exec(text)) {
    const [part] = found;
    if (part === "<!--" || part === '"' || part === "'") return null;
    if (part === "[") inside = true;
    else if (part === "]") inside = false;
    else if (part === ">" && !inside) return parts.lastIndex;
  }
  return null;
}

/** So many letters say what a text is. */
const ENOUGH = 4096;

/** As much of a file as says what it is: more than usual where it begins with blanks or remarks alone. */
export async function headOf(file: Blob): Promise<Uint8Array> {
  for (let size = FIRST_BYTES; ; size *= 16) {
    const head = new Uint8Array(await file.slice(0, size).arrayBuffer());
    const whole = head.length >= file.size || size >= MOST_BYTES;
    if (whole || signatureOf(head) || pastBlanks(decoded(head)).length >= ENOUGH) return head;
  }
}

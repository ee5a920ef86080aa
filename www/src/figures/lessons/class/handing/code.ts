/**
 * Bytes as a word of letters and figures, which no mail and no chat changes, and as figures alone, of which a QR code
 * holds the most. Both say how long they are, so that it is known where they end in a text, and what is cut off.
 */

/** A way to write bytes: blocks of so many, each with as many signs as it needs. */
interface Form {
  /** The first sign says which form it is; another one is of a later version of Frond. */
  mark: string;
  signs: string;
  /** How many signs say how long the rest is. */
  head: number;
}

const FIGURES = "0123456789";
const LETTERS: Form = {
  mark: "A",
  signs: `${FIGURES}ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz`,
  head: 3,
};
const NUMBERS: Form = { mark: "1", signs: FIGURES, head: 5 };

const BLOCK = 32;

/** How many signs hold so many bytes. */
const signsFor = (bytes: number, { signs }: Form) => Math.ceil((8 * bytes) / Math.log2(signs.length) - 1e-9);

function digits(value: bigint, count: number, signs: string): string {
  const base = BigInt(signs.length);
  let rest = value;
  let text = "";
  for (let i = 0; i < count; i++) {
    text = (signs[Number(rest % base)] ?? "") + text;
    rest /= base;
  }
  return text;
}

/** Null where a sign is none of the form. */
function numberIn(text: string, signs: string): bigint | null {
  const base = BigInt(signs.length);
  let value = 0n;
  for (const sign of text) {
    const at = signs.indexOf(sign);
    if (at < 0) return null;
    value = value * base + BigInt(at);
  }
  return value;
}

function written(bytes: Uint8Array, form: Form): string {
  let text = "";
  for (let at = 0; at < bytes.length; at += BLOCK) {
    const block = bytes.subarray(at, at + BLOCK);
    const value = block.reduce((sum, byte) => sum * 256n + BigInt(byte), 0n);
    text += digits(value, signsFor(block.length, form), form.signs);
  }
  return form.mark + digits(BigInt(text.length), form.head, form.signs) + text;
}

/** As a word of letters and figures. */
export const asWord = (bytes: Uint8Array) => written(bytes, LETTERS);

/** As figures alone. */
export const asFigures = (bytes: Uint8Array) => written(bytes, NUMBERS);

const formOf = (code: string) => [LETTERS, NUMBERS].find(({ mark }) => code.startsWith(mark)) ?? null;

/** How many signs a code has that begins like this; null where that cannot be told. */
export function lengthOf(code: string): number | null {
  const form = formOf(code);
  const said = form && code.slice(1, 1 + form.head);
  if (!form || !said || said.length < form.head) return null;
  const length = numberIn(said, form.signs);
  return length === null ? null : 1 + form.head + Number(length);
}

/** The bytes of a whole code; null where it is none. */
export function bytesOf(code: string): Uint8Array | null {
  const form = formOf(code);
  if (!form || lengthOf(code) !== code.length) return null;
  const text = code.slice(1 + form.head);
  const full = signsFor(BLOCK, form);
  const bytes: number[] = [];
  for (let at = 0; at < text.length; at += full) {
    const part = text.slice(at, at + full);
    const count = part.length === full ? BLOCK : bytesIn(part.length, form);
    let value = numberIn(part, form.signs);
    if (count === null || value === null || value >> BigInt(8 * count) !== 0n) return null;
    const block: number[] = [];
    for (let i = 0; i < count; i++) {
      block.unshift(Number(value & 255n));
      value >>= 8n;
    }
    bytes.push(...block);
  }
  return Uint8Array.from(bytes);
}

/** How many bytes so many signs hold; null where no number of bytes needs as many. */
function bytesIn(signs: number, form: Form): number | null {
  for (let count = 1; count < BLOCK; count++) if (signsFor(count, form) === signs) return count;
  return null;
}

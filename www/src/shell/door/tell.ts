/** What a file is, by what is in it: its name may say anything. */
import { otherWords, signatureOf } from "#workers/image/signature";
import * as messages from "./messages";
import { decoded, pastBlanks } from "./tell-head";
import { kindOfJson } from "./tell-json";
import { kindOfTable } from "./tell-table";

/**
 * `picture`: made of pixels. `outline`: a drawing, places, or a table of one or two columns. `maps`: systems, or a
 * document. `animation`: of space.
 */
export type FileKind = "picture" | "outline" | "maps" | "animation" | "empty" | "other";

/** As much of a file is looked at, from where it begins in earnest. */
export const HEAD_BYTES = 64 << 10;
/** The name of a root stands at its beginning: drawings within other documents are not looked for farther on. */
const ROOT_LETTERS = 4096;

/** What steers old machines is in no text, but for tabs and ends of lines, pages and files. */
// biome-ignore lint/suspicious/noControlCharactersInRegex: these are what is looked for
const NO_TEXT = /[\x00-\x08\x0b\x0e-\x19\x1b-\x1f]/;

/** Tells by the first bytes, as `headOf` has them. */
export function tellFile(head: Uint8Array): FileKind {
  const signature = signatureOf(head);
  if (signature) return "picture" in signature ? "picture" : "other";
  const whole = decoded(head);
  const text = pastBlanks(whole).slice(0, HEAD_BYTES);
  // A remark of XML that does not end, or zeros.
  if (text === "") return whole.trim() !== "" || head.includes(0) ? "other" : "empty";
  if (NO_TEXT.test(text)) return "other";
  // Whoever reads outlines says best what is missing.
  return kindOfText(text) ?? "outline";
}

/** Whether a text that is pasted is meant to be opened, and as what; null of a text like any other. */
export function tellPasted(text: string): "outline" | "maps" | "animation" | null {
  const head = pastBlanks(text).slice(0, HEAD_BYTES);
  if (NO_TEXT.test(head)) return null;
  const kind = kindOfText(head, true);
  return kind === "other" ? null : kind;
}

/** What to do with a file that is not read. */
export function wordsForOther(head: Uint8Array): string {
  const signature = signatureOf(head);
  return signature && "other" in signature
    ? messages.recognizedAs(otherWords(signature.other))
    : messages.frondDoesNotRead;
}

/** Whether a picture says in its beginning that Frond saved it. */
export function mayHoldLink(head: Uint8Array): boolean {
  return new TextDecoder("latin1").decode(head.subarray(0, HEAD_BYTES)).includes("iTXtFrond link");
}

/** Null where nothing says what it is. `strict`: braces around words, and a number or two, say nothing. */
function kindOfText(text: string, strict = false): "outline" | "maps" | "animation" | "other" | null {
  if (text.startsWith("<")) return ofXml(text);
  if (isJson(text)) return kindOfJson(text);
  // Remarks before JSON are no part of it, and whoever reads outlines passes them over.
  const bare = withoutRemarks(text);
  if (bare !== text && isJson(bare) && kindOfJson(bare) === "outline") return "outline";
  // Lists of Mathematica.
  if (text.startsWith("{{")) return "maps";
  // Blocks of IFStile begin with @, entries of Fractint stand in braces.
  if ((strict ? BLOCK : /^\s*(@|\$dim)/m).test(text)) return "maps";
  if ((strict ? ENTRY : /^[^;\n]*[{}]/m).test(text)) return "maps";
  const { kind, enough } = kindOfTable(text);
  if (kind !== null && (enough || !strict)) return kind;
  // The signs of remarks in files of maps: what follows is farther on than is looked at.
  return text.startsWith(";") && !strict ? "maps" : null;
}

/** A block of IFStile; an entry of Fractint with its numbers, or a table of LaTeX. */
const BLOCK = /^\s*(@\w*\s*([#;].*)?$|\$dim)/m;
const ENTRY = /\{\s*(?:;[^\n]*\s*)*[-+.\d][-+.\deE,\s]*\s|\\begin\{/;

const isJson = (text: string) => /^\[|^\{\s*["}]/.test(text);

/** What follows `# ..`, `// ..` and `/* .. *\/`. */
function withoutRemarks(text: string): string {
  return text.replace(/^(?:\s+|#[^\r\n]*|\/\/[^\r\n]*|\/\*[\s\S]*?\*\/)+/, "");
}

function ofXml(text: string): "outline" | "maps" | "other" {
  const root = text.slice(0, ROOT_LETTERS);
  if (/<(\w+:)?svg/.test(root)) return "outline";
  return /<(flames?|jwf-flame)\b/i.test(text) ? "maps" : "other";
}

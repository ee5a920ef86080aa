/** Answers out of what a teacher drops or chooses: files of answers, texts with codes, pictures with QR codes. */
import { type Answers, MOST_BYTES, read } from "../answers";
import { codesIn } from "../handing/find";
import type { Problems } from "./arrive";

/** So many files are read at once; a class is smaller. */
const MOST_FILES = 200;
const MOST_TEXT = 20_000_000;
const MOST_PICTURE = 60_000_000;

export interface Unread {
  file: string;
  why: string;
}

export interface Brought extends Problems {
  found: Answers[];
  unread: Unread[];
}

const isPicture = ({ type, name }: File) =>
  type.startsWith("image/") || /\.(?:jpe?g|png|webp|gif|bmp|avif|heic|heif)$/i.test(name);

/** Reads them one after the other; `onStep` hears how many are done. */
export async function bring(files: readonly File[], onStep: (done: number) => void): Promise<Brought> {
  const all: Brought = { found: [], unread: [], damaged: 0, later: 0, more: files.length > MOST_FILES };
  const pictures = files.some(isPicture);
  const reader = pictures ? new (await import("#workers/codes/client")).CodeReader() : null;
  try {
    for (const [i, file] of files.slice(0, MOST_FILES).entries()) {
      onStep(i);
      const texts = isPicture(file) && reader ? await textsOf(file, reader) : await textOf(file);
      if (typeof texts === "string") {
        all.unread.push({ file: file.name, why: texts });
        continue;
      }
      const before = all.found.length;
      for (const text of texts) {
        const { answers, damaged, later, more } = codesIn(text);
        all.found.push(...answers);
        all.damaged += damaged;
        all.later += later;
        all.more ||= more;
      }
      if (all.found.length === before)
        all.unread.push({ file: file.name, why: whyNone(texts, isPicture(file)) });
    }
  } finally {
    reader?.close();
  }
  return all;
}

function whyNone(texts: readonly string[], picture: boolean): string {
  const [first = ""] = texts;
  if (!picture || first.trimStart().startsWith("{")) {
    const why = first.trimStart().startsWith("{") ? read(first) : null;
    return typeof why === "string" ? why : "There are no answers in this file.";
  }
  return otherCode(first);
}

/** What is said of a QR code that holds no answers. */
export function otherCode(text: string): string {
  if (/answers(?:=|%3D)/i.test(text)) return "This code of answers is damaged. Show it once more.";
  if (/#learn\/sheet\//.test(text))
    return "This is the code of the sheet itself. Answers have a code of their own.";
  return "This is another QR code, not one of answers. Pupils find theirs on their sheet, under “Show QR code”.";
}

interface Reader {
  read(picture: ImageBitmap, care: "picture"): Promise<string[]>;
}

async function textsOf(file: File, reader: Reader): Promise<string[] | string> {
  if (file.size > MOST_PICTURE)
    return "This picture is too large. Take a smaller one, or a screenshot of it.";
  let picture: ImageBitmap;
  try {
    picture = await createImageBitmap(file);
  } catch {
    return "This browser cannot open the picture. Save it as JPEG or PNG, and try again.";
  }
  try {
    const texts = await reader.read(picture, "picture");
    return texts.length > 0
      ? texts
      : "No QR code was found in this picture. Take it again, nearer, straight and sharp.";
  } catch (problem) {
    return problem instanceof Error ? problem.message : "This picture could not be read.";
  }
}

async function textOf(file: File): Promise<string[] | string> {
  const json = /\.json$/i.test(file.name) || file.type === "application/json";
  if (file.size > (json ? MOST_BYTES : MOST_TEXT)) return "This file is too large to be one of answers.";
  try {
    return [await file.text()];
  } catch {
    return "This file could not be read. Try it once more.";
  }
}

/** What the QR code of a pupil's answers holds: the link, or figures alone where that is easier to read. */
import { encode } from "uqr";
import type { Answers } from "../answers";
import { asFigures, asWord } from "./code";
import { BEFORE } from "./find";
import { packed } from "./pack";

/** Read at arm's length from a telephone. */
const EASY = 10;
/** Read from near, by a good camera. */
const DENSE = 25;
/** A longer state of an address is not read. */
const MOST_LINK = 3800;

export interface Ways {
  /** Null where it would be too long. */
  link: string | null;
  word: string;
  /** What the QR code holds; null where it would hold too much. */
  qr: string | null;
}

/** `page` is the address of the studio without its #. */
export function waysOf(answers: Answers, page: string): Ways {
  const bytes = packed(answers);
  const word = `${BEFORE}${asWord(bytes)}`;
  const link = word.length > MOST_LINK ? null : `${page}#learn/class/${word}`;
  const figures = asFigures(bytes);
  return {
    link,
    word,
    qr: link !== null && holds(link, EASY) ? link : holds(figures, DENSE) ? figures : null,
  };
}

function holds(text: string, version: number): boolean {
  try {
    encode(text, { ecc: "L", maxVersion: version });
    return true;
  } catch {
    return false;
  }
}

/**
 * A pupil's answers in few bytes, for a link, a word or a QR code:
 *
 *     form (1)  check (3)  saved (4)  how many items, then of each: marks, its number, exercises
 *     all texts, deflated where that is shorter: name, title, and of each item what it has
 *
 * What a code says is not trusted: it is read as a file of answers is.
 */
import { deflateSync, inflateSync } from "fflate";
import { type Answer, type Answers, answersIn } from "../answers";
import { WORDS_1 } from "./words";

const FORM = 1;
/** Whether the texts are deflated stands beside the form. */
const DEFLATED = 0x80;
/** 2020-01-01, from which seconds are counted. */
const EPOCH = Date.UTC(2020, 0, 1);
const MOST_SECONDS = 2 ** 32 - 1;
const HEAD = 8;
/** Texts of a sheet that was answered at full length are shorter. */
const MOST_TEXT = 600_000;
const END = "\0";

const DONE = 1;
const RIGHT = 2;
const WRONG = 4;
/** What is so, in other words than the guess. */
const TRUTH = 8;
/** What is so, in the words of the guess. */
const SAME = 16;
const NAMED = 32;
/** Which kind of item, in the highest bits. */
const SHAPE = 64;
const LINK = 128;

const dictionary = () => new TextEncoder().encode(WORDS_1);

export function packed(answers: Answers): Uint8Array {
  const head: number[] = [];
  const texts: string[] = [answers.name, answers.title];
  number(head, answers.items.length);
  for (const item of answers.items) packItem(item, head, texts);
  const plain = new TextEncoder().encode(texts.map((text) => text.replaceAll(END, " ")).join(END));
  const short = deflateSync(plain, { level: 9, dictionary: dictionary() });
  const deflated = short.length < plain.length;
  const body = Uint8Array.from([...secondsOf(answers.saved), ...head, ...(deflated ? short : plain)]);
  const check = crc(body);
  return Uint8Array.from([
    FORM | (deflated ? DEFLATED : 0),
    (check >>> 16) & 255,
    (check >>> 8) & 255,
    check & 255,
    ...body,
  ]);
}

function packItem(answer: Answer, head: number[], texts: string[]): void {
  const { item, done, exercises, guess, right, truth, name, answer: words } = answer;
  const [, shape] = /^shape:(.+)$/.exec(item) ?? [];
  const [, link] = /^link:(\d+)$/.exec(item) ?? [];
  // Only links have names of their teacher's; what others are called whoever reads it knows.
  const named = link !== undefined && name !== undefined;
  head.push(
    (done ? DONE : 0) |
      (right === true ? RIGHT : right === false ? WRONG : 0) |
      (truth === undefined ? 0 : truth === guess ? SAME : TRUTH) |
      (named ? NAMED : 0) |
      (shape !== undefined ? SHAPE : link !== undefined ? LINK : 0),
  );
  if (shape !== undefined) texts.push(shape);
  else number(head, Number(link ?? item.slice(1)));
  // An exercise a bit; no lesson has thirty.
  number(
    head,
    exercises.filter((one) => one <= 30).reduce((bits, one) => bits | (1 << (one - 1)), 0),
  );
  texts.push(guess);
  if (truth !== undefined && truth !== guess) texts.push(truth);
  if (named) texts.push(name);
  texts.push(words);
}

/** The bytes are not those of a code, or were changed on their way; or they are of a later version. */
export type Unpacked = Answers | "damaged" | "later";

export function unpacked(bytes: Uint8Array): Unpacked {
  const form = bytes[0] ?? 0;
  if ((form & ~DEFLATED) > FORM) return "later";
  if (bytes.length < HEAD || (form & ~DEFLATED) !== FORM) return "damaged";
  const body = bytes.subarray(4);
  const check = ((bytes[1] ?? 0) << 16) | ((bytes[2] ?? 0) << 8) | (bytes[3] ?? 0);
  if (crc(body) !== check) return "damaged";
  try {
    return answersIn(read(new Reader(body), (form & DEFLATED) !== 0)) ?? "damaged";
  } catch {
    return "damaged";
  }
}

function read(from: Reader, deflated: boolean): object {
  const seconds = from.byte() * 2 ** 24 + from.byte() * 2 ** 16 + from.byte() * 2 ** 8 + from.byte();
  const heads = Array.from({ length: Math.min(from.number(), 200) }, () => {
    const marks = from.byte();
    return { marks, number: marks & SHAPE ? 0 : from.number(), bits: from.number() };
  });
  const rest = from.rest();
  const text = new TextDecoder("utf-8", { fatal: true }).decode(deflated ? inflated(rest) : rest);
  const texts = text.split(END);
  const next = () => {
    const one = texts.shift();
    if (one === undefined) throw new Error("a text is missing");
    return one;
  };
  const [name, title] = [next(), next()];
  const items = heads.map(({ marks, number, bits }) => {
    const item = marks & SHAPE ? `shape:${next()}` : marks & LINK ? `link:${number}` : `e${number}`;
    const guess = next();
    const truth = marks & TRUTH ? next() : marks & SAME ? guess : undefined;
    const name = marks & NAMED ? next() : undefined;
    return {
      item,
      done: (marks & DONE) !== 0,
      exercises: Array.from({ length: 30 }, (_, i) => i + 1).filter((one) => bits & (1 << (one - 1))),
      guess,
      ...(marks & (RIGHT | WRONG) ? { right: (marks & RIGHT) !== 0 } : {}),
      ...(truth === undefined ? {} : { truth }),
      ...(name === undefined ? {} : { name }),
      answer: next(),
    };
  });
  return { name, title, saved: seconds === 0 ? "" : timeOf(EPOCH + 1000 * seconds), items };
}

/** A moment as answers have it, to the second. */
export const timeOf = (time: number) => new Date(1000 * Math.floor(time / 1000)).toISOString();

/** Into so much room and no more, whatever the bytes ask for. */
function inflated(bytes: Uint8Array): Uint8Array {
  const room = new Uint8Array(MOST_TEXT);
  return inflateSync(bytes, { out: room, dictionary: dictionary() });
}

function secondsOf(saved: string): number[] {
  const seconds = Math.floor((Date.parse(saved) - EPOCH) / 1000);
  const bounded = Number.isNaN(seconds) ? 0 : Math.min(MOST_SECONDS, Math.max(0, seconds));
  return [24, 16, 8, 0].map((by) => (bounded >>> by) & 255);
}

/** Seven bits a byte, the lowest first; the highest says that more follow. */
function number(into: number[], value: number): void {
  let rest = value >>> 0;
  while (rest > 127) {
    into.push((rest & 127) | 128);
    rest >>>= 7;
  }
  into.push(rest);
}

class Reader {
  readonly #bytes: Uint8Array;
  #at = 0;

  constructor(bytes: Uint8Array) {
    this.#bytes = bytes;
  }

  byte(): number {
    const byte = this.#bytes[this.#at++];
    if (byte === undefined) throw new Error("it ends too early");
    return byte;
  }

  number(): number {
    let value = 0;
    for (let by = 0; by < 35; by += 7) {
      const byte = this.byte();
      value += (byte & 127) * 2 ** by;
      if (byte < 128) return value;
    }
    throw new Error("no number");
  }

  rest(): Uint8Array {
    return this.#bytes.subarray(this.#at);
  }
}

/** The lowest 24 bits of CRC-32 (ISO 3309): one letter more, less or other is always told. */
function crc(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (const byte of bytes) {
    value ^= byte;
    for (let i = 0; i < 8; i++) value = (value >>> 1) ^ (value & 1 ? 0xedb88320 : 0);
  }
  return ~value & 0xffffff;
}

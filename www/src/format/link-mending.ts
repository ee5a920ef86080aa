/**
 * Links on their way: mailers, chats and pages change them. What can only mean one thing is put right, and a check word
 * says whether the end is missing.
 */

/** What does not show, and hard line breaks: sent along by who copies from a page or a mail. */
const INVISIBLE =
  /[\s\u00ad\u200b-\u200f\u2060\ufeff]|%(?:20|0A|0D|09|C2%A[0D]|E2%80%8[B-F]|E2%81%A0|EF%BB%BF)/gi;
/** Signs that links are written with, as others encode them. */
const ENCODED = /%(?:2[1478-9A-F]|3[AB]|40|5F|7[CE])/gi;
/** An ampersand as HTML has it, once or again and again. */
const AMPERSANDS = /&(?:(?:amp|#0*38|%230*38)(?:;|%3B))+/gi;
/** What stands behind a link in a sentence, or around it. */
const BEHIND = /(?:[.,;:!?'"“”’»«)>\]}*_`]|%(?:22|27|29|3E|5D|7D|C2%BB|E2%80%9[9D]))+$/i;
/** What sites add to count where a visitor comes from, where the link has no query of its own. */
const QUERY = /\?.*$/s;
/** Keys whose values are words of the user's: everything may stand in them. */
const WORDS = /name$/;

/** A link that ends within its check word. */
const BARELY = /^v=\d+&c(?:h|he|hec|heck(?:=[0-9a-z-]*)?)?$/;
const CHECKED = /^(v=\d+&)check=([0-9a-z]+)-([0-9a-z]{4})([0-9a-z]{3})(?:&|$)/;
/** The last letters of a link have a word of their own: who shortens one by hand seldom changes its end. */
const END = 8;

/** A word of so many letters for a text: FNV-1a, in base 36. */
function wordOf(text: string, letters: number): string {
  let hash = 0x811c9dc5;
  for (let i = 0; i < text.length; i++) hash = Math.imul(hash ^ text.charCodeAt(i), 0x01000193);
  return ((hash >>> 0) % 36 ** letters).toString(36).padStart(letters, "0");
}

/** A link with its check word: how long the rest is, a word that only such a rest has, and one for its end. */
export function withCheck(link: string): string {
  const version = /^v=\d+&/.exec(link)?.[0];
  if (!version) return link;
  const rest = link.slice(version.length);
  const check = `${rest.length.toString(36)}-${wordOf(rest, 4)}${wordOf(rest.slice(-END), 3)}`;
  return `${version}check=${check}&${rest}`;
}

/** Decodes a link that was encoded as a whole: it has no sign of its own. */
function decoded(link: string): string {
  let text = link;
  for (let i = 0; i < 4 && !text.includes("=") && /^v%(?:25)*3D/i.test(text); i++) {
    try {
      text = decodeURIComponent(text);
    } catch {
      return link;
    }
  }
  // Quoted-printable, as mails are sent: a line that goes on ends in =.
  return /^v=3D/i.test(text) ? text.replace(/=(?:%0D|\r)?(?:%0A|\n)/gi, "").replace(/=3D/gi, "=") : text;
}

function pairMended(pair: string): string {
  const split = pair.indexOf("=");
  if (split < 0) return pair;
  const key = pair.slice(0, split).replace(INVISIBLE, "");
  const value = pair.slice(split + 1);
  if (WORDS.test(key)) return `${key}=${value}`;
  const plain = value.replace(INVISIBLE, "").replace(ENCODED, decodeURIComponent).replace(QUERY, "");
  return `${key}=${plain}`;
}

function mended(link: string): string {
  const pairs = decoded(link.replace(/^[\s\u200b\ufeff]+/, ""))
    .replace(AMPERSANDS, "&")
    .split("&")
    .map(pairMended);
  const last = pairs.pop() ?? "";
  return [...pairs, WORDS.test(last.split("=")[0] ?? "") ? last : last.replace(BEHIND, "")].join("&");
}

/** What became of a link on its way. */
export interface Arrived {
  /** The link, put right where that can only be in one way, without its check word. */
  text: string;
  /** Its last letters, where its end is missing. */
  cutAfter: string | null;
}

/** Looks at a link by its check word; null where that is for another link. */
function checked(link: string): Arrived | null {
  const [all, version, length, word, end] = CHECKED.exec(link) ?? [];
  if (all === undefined || version === undefined || length === undefined) return null;
  const rest = link.slice(all.length);
  const whole = Number.parseInt(length, 36);
  if (rest.length < whole && wordOf(rest.slice(-END), 3) !== end)
    return { text: version + rest, cutAfter: rest.slice(-16) };
  const [own, added] = [rest.slice(0, whole), rest.slice(whole)];
  if (rest.length < whole || wordOf(own, 4) !== word) return null;
  // Somebody may have added a key.
  return { text: version + own + (added.startsWith("&") ? added : ""), cutAfter: null };
}

/** A link as it was sent, as far as that can be told. */
export function arrived(link: string): Arrived {
  if (BARELY.test(link)) return { text: "", cutAfter: link };
  const whole = checked(link);
  if (whole?.cutAfter === null) return whole;
  const text = mended(link);
  // One that was changed by hand says what it says.
  return checked(text) ?? { text: text.replace(CHECKED, "$1"), cutAfter: null };
}

/** The address of a page (`learn/e1`) without what stands behind it; what the page is set to is left alone. */
export function placeOf(fragment: string): string {
  const encoded = /^(?:figures|learn)%2F/i.test(fragment);
  let text = encoded ? fragment.replace(/%2F/gi, "/").replace(/%3D/gi, "=") : fragment;
  text = text.replace(QUERY, "");
  const behind = new RegExp(`(?:${INVISIBLE.source})+$`, "i");
  for (let before = ""; before !== text; ) {
    before = text;
    text = text.replace(behind, "").replace(BEHIND, "");
  }
  return text;
}

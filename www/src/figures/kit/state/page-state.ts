/**
 * What a page of a figure or a lesson was set to, as it stands in its address: `#learn/e7/t=0.4&way=0.3,0.6`. Only what
 * differs from how the page begins is written.
 */
import type { Field } from "./fields";

/** A longer one is no address of a page. */
const LONGEST = 4000;
const MOST = 60;
const NAME = /^[a-z][\w.-]{0,23}$/i;

/** Names and values in the state of an address; null for what no page writes. */
export function valuesIn(state: string): ReadonlyMap<string, string> | null {
  if (state.length > LONGEST) return null;
  const values = new Map<string, string>();
  for (const part of state.split("&", MOST)) {
    if (part === "") continue;
    const [name = "", ...rest] = part.split("=");
    try {
      const value = decodeURIComponent(rest.join("="));
      if (!NAME.test(name)) return null;
      values.set(name, value);
    } catch {
      return null;
    }
  }
  return values;
}

/** As an address has them: what may stand there as it is stays readable. */
export function addressOf(values: Iterable<readonly [name: string, value: string]>): string {
  const written = (value: string) =>
    encodeURIComponent(value).replace(/%(?:2C|3B|3A)/g, (code) => decodeURIComponent(code));
  return [...values].map(([name, value]) => `${name}=${written(value)}`).join("&");
}

/** What one page was opened with, and what it has become. */
export class PageState {
  /** Where the page is, `learn/e7`; empty for what is no page of its own. */
  readonly place: string;
  /** What its address has after the place, as it was opened. */
  readonly state: string;
  readonly #opened: ReadonlyMap<string, string>;
  readonly #now = new Map<string, string>();
  readonly #onUnread: () => void;

  /** `onUnread` is called for each part that cannot be read. */
  constructor(place = "", state = "", onUnread: () => void = () => {}) {
    this.place = place;
    this.state = state;
    const values = valuesIn(state);
    this.#opened = values ?? new Map();
    this.#onUnread = onUnread;
    if (!values) onUnread();
  }

  /** What the address says of this; null where it says nothing, or what cannot be read. */
  opened<T>(name: string, field: Field<T>): T | null {
    const text = this.#opened.get(name);
    if (text === undefined) return null;
    const value = field.read(text);
    if (value === null) this.#onUnread();
    return value;
  }

  /** Notes what it is now; null where it is as it was at first. */
  note(name: string, text: string | null): void {
    if (text === null) this.#now.delete(name);
    else this.#now.set(name, text);
  }

  /** The fragment that leads to the page as it is now, with more before what is noted. */
  fragment(before: Iterable<readonly [string, string]> = []): string {
    const state = addressOf([...before, ...this.#now]);
    return `#${this.place}${state === "" ? "" : `/${state}`}`;
  }
}

/** What is kept of one kind, with names that can be given, and pins. */
import type { Database, Objects, StoreName } from "./database";
import { TooManyPinned } from "./database";

/** What every row has, whatever is kept in it. */
export interface Kept {
  id: string;
  name: string;
  /** The name was given by hand: what is kept later does not change it. */
  named: boolean;
  /** Newer ones do not push it out. */
  pinned: boolean;
  /** When it was kept last, in milliseconds since 1970. */
  time: number;
}

/** Characters of a name. */
export const LONGEST_NAME = 80;

interface Kind<R extends Kept> {
  store: StoreName;
  /** How many are kept besides those that are pinned. */
  most: number;
  /** How many can be pinned. */
  mostPinned: number;
  /** What is in a row besides what every row has; null where it has not its form. */
  sound(read: Record<string, unknown>): Omit<R, keyof Kept> | null;
}

/** The rows of a kind. Every method rejects where the browser keeps nothing. */
export class Rows<R extends Kept> {
  readonly #database: Database;
  readonly #kind: Kind<R>;

  constructor(database: Database, kind: Kind<R>) {
    this.#database = database;
    this.#kind = kind;
  }

  /** Keeps one. What is there already stays pinned and keeps the name that it was given. */
  async put(row: Omit<R, "named" | "pinned">): Promise<void> {
    await this.#change(async (rows) => {
      const before = this.#sound(await rows.get(row.id));
      const { named = false, pinned = false } = before ?? {};
      const name = before && named ? before.name : row.name.slice(0, LONGEST_NAME);
      await rows.put({ ...row, name, named, pinned });
      const loose = (await this.#all(rows)).filter((one) => !one.pinned);
      for (const old of newestFirst(loose).slice(this.#kind.most)) await rows.delete(old.id);
    });
  }

  /** Puts back what was removed, as it was. */
  restore(row: R): Promise<void> {
    return this.#change((rows) => rows.put(row));
  }

  /** All that can be read, the newest first, what is pinned before the others. */
  async list(): Promise<R[]> {
    const rows = (await this.#database.all(this.#kind.store)).flatMap((one) => this.#sound(one) ?? []);
    return newestFirst(rows).sort((a, b) => Number(b.pinned) - Number(a.pinned));
  }

  rename(id: string, name: string): Promise<void> {
    return this.#alter(id, { name: name.trim().slice(0, LONGEST_NAME), named: true });
  }

  pin(id: string, pinned: boolean): Promise<void> {
    return this.#alter(id, { pinned });
  }

  remove(id: string): Promise<void> {
    return this.#change((rows) => rows.delete(id));
  }

  /** Pinned or not, and what cannot be read. */
  clear(): Promise<void> {
    return this.#change((rows) => rows.clear());
  }

  close(): Promise<void> {
    return this.#database.close();
  }

  /** Another tab may have removed it. */
  #alter(id: string, change: Partial<Kept>): Promise<void> {
    return this.#change(async (rows) => {
      const row = this.#sound(await rows.get(id));
      if (!row) return;
      if (change.pinned && !row.pinned) {
        const pinned = (await this.#all(rows)).filter((one) => one.pinned);
        if (pinned.length >= this.#kind.mostPinned) throw new TooManyPinned(this.#kind.mostPinned);
      }
      await rows.put({ ...row, ...change });
    });
  }

  async #all(rows: Objects): Promise<R[]> {
    return (await rows.getAll()).flatMap((one) => this.#sound(one) ?? []);
  }

  #change(work: (rows: Objects) => Promise<unknown>): Promise<void> {
    return this.#database.change(this.#kind.store, work);
  }

  /** What was read, if it has the form of a row: other programs of this address could have written it. */
  #sound(read: unknown): R | null {
    if (typeof read !== "object" || read === null) return null;
    const { id, name, named, pinned, time } = read as Record<string, unknown>;
    if (typeof id !== "string" || typeof name !== "string") return null;
    if (typeof time !== "number" || !Number.isFinite(time)) return null;
    const content = this.#kind.sound(read as Record<string, unknown>);
    if (!content) return null;
    const kept: Kept = {
      id,
      name: name.slice(0, LONGEST_NAME),
      named: named === true,
      pinned: pinned === true,
      time,
    };
    return { ...content, ...kept } as R;
  }
}

function newestFirst<R extends Kept>(rows: R[]): R[] {
  return rows.sort((a, b) => b.time - a.time || (a.id < b.id ? -1 : 1));
}

/** Characters of a fragment: no link is longer. */
const LONGEST_FRAGMENT = 1 << 20;

/** A fragment of a link, as long as links are. */
export function soundFragment(read: unknown): string | null {
  return typeof read === "string" && read !== "" && read.length <= LONGEST_FRAGMENT ? read : null;
}

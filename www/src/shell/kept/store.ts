/** Documents that are kept in this browser: each is a link's fragment, with a name. */
import { type DBSchema, type IDBPDatabase, openDB } from "idb";

/** A document that was kept. */
export interface Row {
  id: string;
  /** The document, as a link holds it. */
  fragment: string;
  name: string;
  /** The name was given by hand: what is kept later does not change it. */
  named: boolean;
  /** Newer ones do not push it out. */
  pinned: boolean;
  /** When it was kept last, in milliseconds since 1970. */
  time: number;
}

interface Schema extends DBSchema {
  documents: { key: string; value: Row };
}

/** Documents that are kept besides those that are pinned. */
export const MOST = 20;
/** Characters of a name. */
export const LONGEST_NAME = 80;
/** Characters of a fragment: no link is longer. */
const LONGEST_FRAGMENT = 1 << 20;
/** Goes up when rows change their form. */
export const VERSION = 1;
const DATABASE = "frond";

/** The store, opened when it is first asked for. Every method rejects where the browser keeps nothing. */
export class Store {
  #open: Promise<IDBPDatabase<Schema>> | null = null;

  /** Keeps a document. One that is there already stays pinned and keeps the name that it was given. */
  async put(row: Pick<Row, "id" | "fragment" | "name" | "time">): Promise<void> {
    const name = row.name.slice(0, LONGEST_NAME);
    await this.#change(async (documents) => {
      const before = sound(await documents.get(row.id));
      const { named = false, pinned = false } = before ?? {};
      await documents.put({ ...row, name: before && named ? before.name : name, named, pinned });
      const loose = (await documents.getAll())
        .flatMap((one) => sound(one) ?? [])
        .filter((one) => !one.pinned);
      for (const old of newestFirst(loose).slice(MOST)) await documents.delete(old.id);
    });
  }

  /** All that can be read, the newest first, what is pinned before the others. */
  async list(): Promise<Row[]> {
    const rows = (await (await this.#database()).getAll("documents")).flatMap((one) => sound(one) ?? []);
    return newestFirst(rows).sort((a, b) => Number(b.pinned) - Number(a.pinned));
  }

  rename(id: string, name: string): Promise<void> {
    return this.#alter(id, { name: name.trim().slice(0, LONGEST_NAME), named: true });
  }

  pin(id: string, pinned: boolean): Promise<void> {
    return this.#alter(id, { pinned });
  }

  remove(id: string): Promise<void> {
    return this.#change((documents) => documents.delete(id));
  }

  /** Pinned or not, and what cannot be read. */
  clear(): Promise<void> {
    return this.#change((documents) => documents.clear());
  }

  async close(): Promise<void> {
    const database = await this.#open?.catch(() => null);
    this.#open = null;
    database?.close();
  }

  /** Another tab may have removed it. */
  #alter(id: string, change: Partial<Row>): Promise<void> {
    return this.#change(async (documents) => {
      const row = sound(await documents.get(id));
      if (row) await documents.put({ ...row, ...change });
    });
  }

  /** All of it, or, where there is no room, nothing. */
  async #change(work: (documents: Documents) => Promise<unknown>): Promise<void> {
    const transaction = (await this.#database()).transaction("documents", "readwrite");
    const ended = transaction.done;
    // Told below, unless the work has already said what went wrong.
    ended.catch(() => {});
    try {
      await work(transaction.store);
    } catch (problem) {
      try {
        transaction.abort();
      } catch {
        // It has ended by itself.
      }
      throw problem;
    }
    await ended;
  }

  #database(): Promise<IDBPDatabase<Schema>> {
    if (this.#open) return this.#open;
    const opening = openDB<Schema>(DATABASE, VERSION, {
      upgrade(database) {
        database.createObjectStore("documents", { keyPath: "id" });
      },
      // A newer page waits for this one to let go; what is asked next is told that it is the older.
      blocking: () => void this.close(),
      terminated: () => {
        this.#open = null;
      },
    });
    this.#open = opening;
    opening.catch(() => {
      if (this.#open === opening) this.#open = null;
    });
    return opening;
  }
}

type Documents = {
  get(id: string): Promise<unknown>;
  getAll(): Promise<unknown[]>;
  put(row: Row): Promise<unknown>;
  delete(id: string): Promise<void>;
  clear(): Promise<void>;
};

function newestFirst(rows: Row[]): Row[] {
  return rows.sort((a, b) => b.time - a.time || (a.id < b.id ? -1 : 1));
}

/** What was read, if it has the form of a row: other programs of this address could have written it. */
function sound(read: unknown): Row | null {
  if (typeof read !== "object" || read === null) return null;
  const { id, fragment, name, named, pinned, time } = read as Record<string, unknown>;
  if (typeof id !== "string" || typeof name !== "string" || typeof fragment !== "string") return null;
  if (typeof time !== "number" || !Number.isFinite(time)) return null;
  if (fragment === "" || fragment.length > LONGEST_FRAGMENT) return null;
  return {
    id,
    fragment,
    name: name.slice(0, LONGEST_NAME),
    named: named === true,
    pinned: pinned === true,
    time,
  };
}

/** Why nothing is kept, and what can be done. */
export function reasonOf(problem: unknown): string {
  const name = problem instanceof Error || problem instanceof DOMException ? problem.name : "";
  if (name === "QuotaExceededError")
    return "There is no room left in this browser. Remove some of what is kept, or save the link.";
  if (name === "VersionError")
    return "A newer Frond keeps your work here. Load this page anew to see it; the address holds what you made.";
  return "This browser keeps nothing for Frond, as in a private window. The address holds what you made.";
}

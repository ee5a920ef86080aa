/** Where this browser keeps what a person makes: one database, and a store in it for each kind of thing. */
import { type IDBPDatabase, openDB } from "idb";
import * as messages from "../messages";

/** Stores are added at the end, each with a version of its own. */
const STORES = ["documents", "fits", "answers"] as const;

export type StoreName = (typeof STORES)[number];

/** Goes up with another store, and when rows change their form. */
export const VERSION = STORES.length;
const DATABASE = "frond";

/** What is done within one transaction. */
export type Work = (store: Objects) => Promise<unknown>;

/** The store of a transaction: what is read may be of any form. */
export interface Objects {
  get(id: string): Promise<unknown>;
  getAll(): Promise<unknown[]>;
  put(row: object): Promise<unknown>;
  delete(id: string): Promise<void>;
  clear(): Promise<void>;
}

/** The database, opened when it is first asked for. Every method rejects where the browser keeps nothing. */
export class Database {
  #open: Promise<IDBPDatabase> | null = null;

  async all(store: StoreName): Promise<unknown[]> {
    return (await this.#database()).getAll(store);
  }

  /** All of it, or, where there is no room, nothing. */
  async change(store: StoreName, work: Work): Promise<void> {
    const transaction = (await this.#database()).transaction(store, "readwrite");
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

  async close(): Promise<void> {
    const database = await this.#open?.catch(() => null);
    this.#open = null;
    database?.close();
  }

  #database(): Promise<IDBPDatabase> {
    if (this.#open) return this.#open;
    const opening = openDB(DATABASE, VERSION, {
      upgrade(database, before) {
        for (const store of STORES.slice(before)) database.createObjectStore(store, { keyPath: "id" });
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

/** The one of this page. */
export const database = new Database();

/** `randomUUID` is for secure pages only. */
export const newId = (): string =>
  Array.from(crypto.getRandomValues(new Uint32Array(4)), (part) => part.toString(36)).join("-");

/** Why nothing is kept, and what can be done. */
export function reasonOf(problem: unknown): string {
  const name = problem instanceof Error || problem instanceof DOMException ? problem.name : "";
  if (problem instanceof TooManyPinned) return messages.tooManyPinned(problem.most);
  if (name === "QuotaExceededError") return messages.noRoom;
  if (name === "VersionError") return messages.newerFrond;
  return messages.notStored;
}

/** What is pinned is never pushed out, so that it has a bound of its own. */
export class TooManyPinned extends Error {
  readonly most: number;

  constructor(most: number) {
    super(messages.tooManyPinned(most));
    this.most = most;
  }
}

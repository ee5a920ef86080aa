/** What a class has handed in, kept in this browser alone until the teacher clears it. */
import { type Database, database as shared } from "#document/kept/database";
import { type Answers, answersIn, keyOf, latest } from "../answers";

/** Pupils' answers that are kept: the classes of a school year, and far less than a browser has room for. */
export const MOST_KEPT = 2000;

/** The answers of this browser. Every method rejects where it keeps nothing. */
export class HandedIn {
  readonly #database: Database;

  constructor(database: Database = shared) {
    this.#database = database;
  }

  /** All that can be read, the latest of each name for each sheet. */
  async list(): Promise<Answers[]> {
    const rows = await this.#database.all("answers");
    return latest(rows.flatMap((row) => answersIn(row) ?? []));
  }

  /** Keeps them. What the same name answered to the same sheet before gives way; of too many the oldest do. */
  keep(answers: readonly Answers[]): Promise<void> {
    return this.#database.change("answers", async (rows) => {
      const before = (await rows.getAll()).flatMap((row) => answersIn(row) ?? []);
      const newestFirst = latest([...before, ...answers]).sort((p, q) => (p.saved < q.saved ? 1 : -1));
      await rows.clear();
      for (const one of newestFirst.slice(0, MOST_KEPT)) await rows.put({ id: keyOf(one), ...one });
    });
  }

  /** Removes these. */
  remove(answers: readonly Answers[]): Promise<void> {
    return this.#database.change("answers", async (rows) => {
      for (const one of answers) await rows.delete(keyOf(one));
    });
  }
}

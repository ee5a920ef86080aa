/** Documents that are kept in this browser: each is a link's fragment, with a name. */
import { Database } from "#document/kept/database";
import { type Kept, Rows, soundFragment } from "#document/kept/rows";

/** A document that was kept. */
export interface Row extends Kept {
  /** The document, as a link holds it. */
  fragment: string;
}

/** Documents that are kept besides those that are pinned. */
export const MOST = 20;

/** The documents of this browser. */
export class Store extends Rows<Row> {
  constructor(database = new Database()) {
    super(database, {
      store: "documents",
      most: MOST,
      mostPinned: Number.POSITIVE_INFINITY,
      sound(read) {
        const fragment = soundFragment(read["fragment"]);
        return fragment === null ? null : { fragment };
      },
    });
  }
}

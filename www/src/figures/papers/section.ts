/** A numbered section of a paper, and what Frond has of it. */
import type { Tool } from "#wasm/api";

export interface Section {
  /** As the paper counts. */
  number: string;
  /** As the paper has it. */
  title: string;
  /** What stands there, in a sentence, and where Frond has none of it, that. */
  about: string;
  /** The numbered things that are printed in it, for whoever looks for one: "Theorem 2, equation 4". */
  holds?: string;
  /** The figures and tables that belong to it, by the ids of their pages. */
  pages?: readonly string[];
  /** Other pages and lessons that show it. */
  also?: readonly string[];
  /** Where one does it with shapes of one's own. */
  tools?: readonly Tool[];
}

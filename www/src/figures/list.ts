import type { ComponentType } from "preact";
import { Figure1 } from "./burch-hart/figure-1/page";
import { Figure2 } from "./burch-hart/figure-2/page";
import { Figure5 } from "./burch-hart/figure-5/page";
import { Figure6 } from "./burch-hart/figure-6/page";
import { Figure7 } from "./burch-hart/figure-7/page";
import { Figures34 } from "./burch-hart/figures-3-and-4/page";
import { Table1 } from "./burch-hart/table-1/page";
import * as thumbs from "./burch-hart/thumbs";
import { FITS } from "./cochran/list";
import { SPACES } from "./darwish/list";
import { DEFORMS } from "./fujimoto/list";
import type { Heading } from "./kit/frame/frame";
import { LESSONS } from "./lessons/list";

export interface Entry {
  /** The part of the address behind `#figures/`; further ones lead to the same page. */
  id: string;
  also?: readonly string[];
  /** As the paper counts. */
  number: string;
  /** The same in the row of all figures. */
  short: string;
  title: string;
  /** One line for the index. */
  about: string;
  Page: ComponentType<Heading>;
  Thumb: ComponentType;
}

export const CATALOGUE: readonly Entry[] = [
  {
    id: "1",
    number: "Figure 1",
    short: "1",
    title: "When is a shape proved to be in pieces?",
    about: "Barnsley’s test on a Cantor dust that closes at one half.",
    Page: Figure1,
    Thumb: thumbs.Dust,
  },
  {
    id: "2",
    number: "Figure 2",
    short: "2",
    title: "Connected, as far as pixels tell",
    about: "The index buffer: pixels collide, and a graph gains its edges.",
    Page: Figure2,
    Thumb: thumbs.Buffer,
  },
  {
    id: "3",
    also: ["4"],
    number: "Figures 3 and 4",
    short: "3, 4",
    title: "Two ways to turn a map around",
    about: "Number by number a map collapses on the way; turned, it keeps its size.",
    Page: Figures34,
    Thumb: thumbs.Turning,
  },
  {
    id: "5",
    number: "Figure 5",
    short: "5",
    title: "The straight way from dragon to gasket",
    about: "A morph that nobody watches falls apart.",
    Page: Figure5,
    Thumb: thumbs.Straight,
  },
  {
    id: "6",
    number: "Figure 6",
    short: "6",
    title: "The way that holds together",
    about: "The same morph, led along a path on which the shape stays in one piece.",
    Page: Figure6,
    Thumb: thumbs.Planned,
  },
  {
    id: "7",
    number: "Figure 7",
    short: "7",
    title: "The map of all in‑betweens",
    about: "The connectedness locus, with both ways drawn on it.",
    Page: Figure7,
    Thumb: thumbs.Locus,
  },
  {
    id: "table-1",
    number: "Table 1",
    short: "Table 1",
    title: "How well do pixels tell?",
    about: "The index buffer measured at four resolutions, here and now.",
    Page: Table1,
    Thumb: thumbs.Accuracy,
  },
];

export { DEFORMS, FITS, LESSONS, SPACES };

/** Where an address leads: one of a row of pages, with the row that it is in. */
export function find(id: string): { row: readonly Entry[]; index: number } | null {
  const asked = id.toLowerCase();
  for (const row of [CATALOGUE, DEFORMS, FITS, SPACES, LESSONS]) {
    const index = row.findIndex((entry) => entry.id === asked || entry.also?.includes(asked));
    if (index >= 0) return { row, index };
  }
  return null;
}

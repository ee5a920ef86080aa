/** The numbered sections of the four papers, each with what shows it here. */
import type { Figure, Row } from "../figure";
import { found } from "../find/words";
import { ROWS } from "../list";
import { BURCH_HART } from "./burch-hart";
import { COCHRAN } from "./cochran";
import { DARWISH } from "./darwish";
import { FUJIMOTO } from "./fujimoto";
import type { Section } from "./section";

const OF_ROW: Readonly<Record<string, readonly Section[]>> = {
  "from-the-paper": BURCH_HART,
  deformation: FUJIMOTO,
  "rough-curves": COCHRAN,
  "in-space": DARWISH,
};

/** The sections of a row's paper, in their order. */
export const sectionsOf = (row: Row): readonly Section[] => OF_ROW[row.id] ?? [];

/** The section that the figure of a page belongs to. */
export function sectionWith(row: Row, figure: Figure): Section | undefined {
  return sectionsOf(row).find(({ pages = [] }) => pages.includes(figure.id));
}

export interface FoundSections {
  row: Row;
  sections: readonly Section[];
}

/** The sections of which each word is said, those that are asked for by their number first. */
export function sectionsFound(asked: string): FoundSections[] {
  return ROWS.flatMap((row) => {
    const text = ({ number, title, about, holds = "" }: Section) => [
      `section § ${number}`,
      row.paper ?? "",
      title,
      about,
      holds,
    ];
    const sections = found(sectionsOf(row), asked, text, ({ number }) => number);
    return sections.length === 0 ? [] : [{ row, sections }];
  });
}

/** The figures of which each word is said. */
export function figuresFound(asked: string): Figure[] {
  return ROWS.flatMap((row) =>
    found(
      row.figures,
      asked,
      ({ number, title, about }) => [number, title, about, row.paper ?? ""],
      ({ short }) => short,
    ),
  );
}

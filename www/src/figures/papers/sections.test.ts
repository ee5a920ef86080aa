import { describe, expect, it } from "vitest";
import { find, ROWS } from "../list";
import { figuresFound, sectionsFound, sectionsOf, sectionWith } from "./sections";

/** The numbers of the sections as they stand in the papers. */
const NUMBERED: Readonly<Record<string, string>> = {
  "from-the-paper": "1 2 2.1 2.2 3 4 4.1 4.2 4.3 5 6 6.1 6.2 7 7.1 7.2",
  deformation: "1 2 3 4 5 5.1 5.2 5.3 5.4 6",
  "rough-curves": "1 1.1 1.2 2 2.1 2.2 2.3 2.4 3 3.1 3.2 4 4.1 4.2 4.3 5 5.1 5.2",
  "in-space": "1 2 3 3.1 3.2 3.3 3.4 3.5 3.6 4",
};
/** How many equations each numbers. */
const EQUATIONS: Readonly<Record<string, number>> = {
  "from-the-paper": 6,
  deformation: 19,
  "rough-curves": 15,
  "in-space": 2,
};

describe.each(ROWS)("$paper", (row) => {
  const sections = sectionsOf(row);

  it("has an entry for every numbered section, in their order", () => {
    expect(sections.map(({ number }) => number).join(" ")).toBe(NUMBERED[row.id]);
  });

  it("says of each what stands there, and leads to pages that there are", () => {
    for (const { number, title, about, pages = [], also = [] } of sections) {
      expect(title, number).toMatch(/^\p{Lu}/u);
      expect(about, number).toMatch(/^\p{Lu}.*\.$/u);
      for (const id of [...pages, ...also]) expect(find(id)?.figure.id, `${number}: ${id}`).toBe(id);
      expect(new Set([...pages, ...also]).size, number).toBe(pages.length + also.length);
    }
  });

  it("leads to something, but for what shows nothing", () => {
    const bare = sections.filter(({ pages, also, tools }) => !pages && !also && !tools);
    for (const { title } of bare) expect(title).toMatch(/^(Acknowledgments|Previous Work|Overview)$/);
  });

  it("has each figure in one section", () => {
    const printed = sections.flatMap(({ pages = [] }) => pages);
    expect([...printed].sort()).toEqual(row.figures.map(({ id }) => id).sort());
    for (const figure of row.figures) expect(sectionWith(row, figure)?.pages).toContain(figure.id);
  });

  it("finds every equation", () => {
    for (let n = 1; n <= (EQUATIONS[row.id] ?? 0); n++) {
      const found = sectionsFound(`${row.paper} equation ${n}`);
      expect(
        found.map(({ row }) => row.id),
        `equation ${n}`,
      ).toContain(row.id);
    }
  });
});

const firstOf = (asked: string) => {
  const [{ row, sections: [first] = [] } = { row: undefined }] = sectionsFound(asked);
  return [row?.id, first?.number];
};

it.each([
  ["Darwish 3.6", "in-space", "3.6"],
  ["Fujimoto 3", "deformation", "3"],
  ["fujimoto et al. §5.4", "deformation", "5.4"],
  ["Burch and Hart 6.2", "from-the-paper", "6.2"],
  ["burch & hart, section 6.2", "from-the-paper", "6.2"],
  ["Cochran 2.4", "rough-curves", "2.4"],
  ["Theorem 2 Burch", "from-the-paper", "4.2"],
  ["Hausdorff", "in-space", "3.2"],
])("%s is found first", (asked, row, number) => {
  expect(firstOf(asked)).toEqual([row, number]);
});

it("finds figures by their paper and number", () => {
  expect(figuresFound("Burch Table 1").map(({ id }) => id)).toEqual(["table-1"]);
  expect(figuresFound("Fujimoto Figure 6").map(({ id }) => id)).toEqual(["d6"]);
  expect(figuresFound(" ")).toEqual([]);
  expect(figuresFound("zebra")).toEqual([]);
});

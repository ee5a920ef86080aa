/** Every file, folder and heading that the papers and the tops of the crates name is there. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";

const root = fileURLToPath(new URL("../..", import.meta.url));
const missing = (places: readonly string[]) => places.filter((place) => !existsSync(root + place));
const papersOf = (folder: string) =>
  readdirSync(root + folder)
    .filter((file) => file.endsWith(".md"))
    .map((file) => join(folder, file));

const PAPERS = [...papersOf("."), ...papersOf("docs"), ...papersOf("docs/decisions")];

/** The anchors of a paper, made from its headings as code forges make them. */
const anchorsOf = (paper: string) =>
  [...readFileSync(root + paper, "utf8").matchAll(/^#+ (.*)$/gm)].map(([, title = ""]) =>
    title
      .toLowerCase()
      .replace(/[^\p{L}\p{N} _-]/gu, "")
      .replaceAll(" ", "-"),
  );

describe.each(PAPERS)("%s", (paper) => {
  const text = readFileSync(root + paper, "utf8");

  it("names what is there", () => {
    const named = [...text.matchAll(/`((?:crate|www|tests|docs)\/[\w./-]+)`/g)].map(
      ([, place = ""]) => place,
    );
    expect(missing(named)).toEqual([]);
  });

  it("links to papers, pictures and headings that are there", () => {
    const links = [...text.matchAll(/\]\(([^)]+)\)/g)].map(([, link = ""]) => link);
    const broken = links
      .filter((link) => !/^\w+:/.test(link))
      .filter((link) => {
        const [file = "", anchor] = link.split("#");
        const target = file === "" ? paper : join(dirname(paper), file);
        return !existsSync(root + target) || (anchor && !anchorsOf(target).includes(anchor));
      });
    expect(broken).toEqual([]);
  });
});

it("the papers name files", () => {
  for (const paper of ["ARCHITECTURE.md", "CONTRIBUTING.md"]) {
    expect(readFileSync(root + paper, "utf8")).toMatch(/`(?:crate|www|tests)\//);
  }
});

it.each(readdirSync(`${root}crate`).filter((crate) => crate !== "xtask"))("the top of %s does", (crate) => {
  const top = readFileSync(`${root}crate/${crate}/src/lib.rs`, "utf8").match(/^\/\/!.*$/gm) ?? [];
  const named = [...top.join("\n").matchAll(/`(\w+\/[\w/]*)`/g)].map(([, place = ""]) =>
    place.replace(/\/$/, ""),
  );
  const found = (place: string) =>
    [place, `src/${place}`, `src/${place}.rs`].some((at) => missing([`crate/${crate}/${at}`]).length === 0);
  expect(named.filter((place) => !found(place))).toEqual([]);
});

/** Every file and folder that the papers and the tops of the crates name is there. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";

const root = fileURLToPath(new URL("../..", import.meta.url));
const missing = (places: readonly string[]) => places.filter((place) => !existsSync(root + place));

it.each(["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"])("%s names what is there", (paper) => {
  const text = readFileSync(root + paper, "utf8");
  const named = [...text.matchAll(/`((?:crate|www|tests)\/[\w./-]+)`/g)].map(([, place = ""]) => place);
  expect(named.length).toBeGreaterThan(0);
  expect(missing(named)).toEqual([]);
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

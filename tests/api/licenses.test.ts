/** The licences of all that is shipped, and that each may be. */
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { chosen, crates, licenseText, scripts } from "../../www/build/licenses";

describe("an expression of licences", () => {
  it("is taken by the first that is allowed, where one may choose", () => {
    expect(chosen("MIT OR Apache-2.0")).toEqual(["MIT"]);
    expect(chosen("Apache-2.0/MIT")).toEqual(["MIT"]);
    expect(chosen("GPL-3.0-only OR Zlib")).toEqual(["Zlib"]);
    expect(chosen("(MIT OR Apache-2.0) AND Unicode-3.0")).toEqual(["MIT", "Unicode-3.0"]);
    expect(chosen("MIT AND Zlib OR Apache-2.0")).toEqual(["Apache-2.0"]);
  });

  it("is refused where any part of it that has to be kept is not allowed", () => {
    for (const refused of ["", "GPL-3.0-only", "MIT AND GPL-3.0-only", "(MIT OR Zlib", "MIT Zlib", "OR"])
      expect(() => chosen(refused), refused).toThrow("none of those that Frond ships");
  });
});

describe("the licences that are shipped", () => {
  it("are those of what the modules and the scripts are made of, each with its text", () => {
    const parts = [...crates(), ...scripts()];
    const names = parts.map(({ name }) => name);
    for (const name of ["wgpu", "serde", "num-bigint", "preact", "mediabunny", "@preact/signals-core"])
      expect(names).toContain(name);
    // Compiles, tests and checks, and is in nothing that is sent.
    for (const name of [
      "syn",
      "serde_derive",
      "vite",
      "vitest",
      "proptest",
      "@types/dom-webcodecs",
      "frond-core",
    ])
      expect(names).not.toContain(name);
    const text = licenseText(parts);
    for (const { name, version, source } of parts) {
      expect(text).toContain(`${name} ${version}, `);
      expect(text).toContain(source);
    }
    expect(text).toContain("Mozilla Public License Version 2.0");
    expect(text).toContain("Jason Miller");
  });

  it("name all that may not be, and what lacks its text", () => {
    const folder = mkdtempSync(join(tmpdir(), "frond-licenses-"));
    const part = { version: "1.0.0", source: "https://example.org/", folder };
    const bare = { ...part, name: "bare", license: "MIT" };
    expect(() => licenseText([{ ...part, name: "sealed", license: "GPL-3.0-only" }, bare])).toThrow(
      /bare 1\.0\.0: bare brings no text.*\nsealed 1\.0\.0: .*"GPL-3\.0-only"/,
    );
    // Of several crates of one owner one may bring the text for all.
    const beside = mkdtempSync(join(tmpdir(), "frond-licenses-"));
    writeFileSync(join(beside, "LICENSE"), "As we like.");
    const own = { ...bare, source: "https://example.org/owner/a" };
    const sibling = { ...own, name: "sibling", source: "https://example.org/owner/b", folder: beside };
    expect(licenseText([own, sibling])).toContain("bare 1.0.0, sibling 1.0.0\n\nAs we like.");
    expect(() => licenseText([own, { ...sibling, source: "https://example.org/else/b" }])).toThrow("no text");
    expect(() => licenseText([own, { ...sibling, license: "Zlib" }])).toThrow("no text");
    rmSync(beside, { recursive: true });
    writeFileSync(join(folder, "LICENSE"), "As you like.");
    const text = licenseText([bare, { ...bare, name: "other" }]);
    expect(text).toContain("bare 1.0.0, other 1.0.0\n\nAs you like.");
    rmSync(folder, { recursive: true });
  });
});

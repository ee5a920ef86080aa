/** `docs/embed.md` shows the lines that `tests/hosts` runs, at the versions that it installs. */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, test } from "vitest";
import { HOSTS, pinsOf } from "../hosts/hosts.mjs";

const root = fileURLToPath(new URL("../..", import.meta.url));
const doc = readFileSync(join(root, "docs/embed.md"), "utf8");
interface Host {
  programs?: string[];
  headers?: Record<string, string>;
  [more: string]: unknown;
}
const known: Record<string, Host> = HOSTS;

/** The code of the document, by the file that it names. */
const shown = new Map(
  [...doc.matchAll(/<!-- (tests\/hosts\/.*) -->\n```\w*\n([\s\S]*?)```/g)].map(([, file = "", code = ""]) => [
    file,
    code,
  ]),
);

test("the document shows what is run, to the letter", () => {
  expect(shown.size).toBe(doc.match(/<!-- tests/g)?.length);
  for (const [file, code] of shown) {
    const text = file.endsWith(" policy")
      ? `${known["policy"]?.headers?.["content-security-policy"]?.replaceAll("; ", ";\n")}\n`
      : readFileSync(join(root, file), "utf8");
    expect(code, file).toBe(text);
  }
});

test("its table has a row for each host, with the versions that are installed", () => {
  const rows = [...doc.matchAll(/^\|(.*)\|(.*)\| `cargo xtask test hosts -- (\S+)` \|$/gm)];
  expect(rows.map(([, , , name]) => name).toSorted()).toEqual(Object.keys(known).toSorted());
  for (const [, , versions = "", name = ""] of rows) {
    const pinned = pinsOf(join(root, "tests/hosts", name));
    const named = [...versions.matchAll(/([\w.-]+) (\d+\.\d+\.\d+)/g)];
    for (const [, program = "", version] of named)
      expect(pinned[program], `${name}: ${program}`).toBe(version);
    for (const program of known[name]?.programs ?? [])
      expect(
        named.map(([, other]) => other),
        name,
      ).toContain(program);
  }
});

test("each folder is a host, pinned to exact versions, and the other test of the table is there", () => {
  const folders = readdirSync(join(root, "tests/hosts"), { withFileTypes: true });
  const names = folders.filter((entry) => entry.isDirectory()).map(({ name }) => name);
  expect(names.toSorted()).toEqual(Object.keys(known).toSorted());
  for (const name of names) {
    for (const version of Object.values(pinsOf(join(root, "tests/hosts", name))))
      expect(version, name).toMatch(/^\d+\.\d+\.\d+$/);
  }
  for (const [, spec = ""] of doc.matchAll(/test webgl2 -- (\S+\.ts)/g))
    expect(existsSync(join(root, "tests/e2e", spec)), spec).toBe(true);
});

/**
 * The licences of all that is shipped: the crates that the modules are compiled of, as Cargo names them, and the
 * packages that the scripts are bundled of, as npm's lock file does. One that is not allowed ends the build.
 */
import { execFileSync } from "node:child_process";
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../..", import.meta.url));

/** What may be shipped; of several that are offered the first of these is taken. */
const ALLOWED = [
  "MIT",
  "Apache-2.0",
  "Zlib",
  "BSD-2-Clause",
  "BSD-3-Clause",
  "ISC",
  "Unicode-3.0",
  "MPL-2.0",
];

/** Files of a package that say what it may be used for. */
const LICENSE_FILE = /^(licen[sc]e|copying|copyright|notice|unlicense)/i;

/** What the file of a licence has in its name, where a package offers several. */
const NAMES: Readonly<Record<string, RegExp>> = {
  MIT: /mit/i,
  "Apache-2.0": /apache/i,
  Zlib: /zlib/i,
  "BSD-2-Clause": /bsd/i,
  "BSD-3-Clause": /bsd/i,
  "Unicode-3.0": /unicode/i,
};

/** Something that is shipped. */
export interface Part {
  name: string;
  version: string;
  /** As SPDX writes it; older crates have a slash for OR. */
  license: string;
  /** Where its sources are. */
  source: string;
  folder: string;
}

/** The licences by which an expression is taken; throws where that cannot be. */
export function chosen(expression: string): string[] {
  const words = expression.replaceAll("/", " OR ").match(/[()]|[\w.+-]+/g) ?? [];
  let at = 0;
  const take = (word: string) => words[at] === word && ++at > 0;
  // Of several ways the one by fewest licences, then the one that is named first above. None is null.
  const rank = (way: string[]) =>
    way.length * ALLOWED.length + Math.max(...way.map((one) => ALLOWED.indexOf(one)));
  const either = (): string[] | null => {
    let best = both();
    while (take("OR")) {
      const other = both();
      if (other && (!best || rank(other) < rank(best))) best = other;
    }
    return best;
  };
  const both = (): string[] | null => {
    let all = one();
    while (take("AND")) {
      const other = one();
      all = all && other && [...new Set([...all, ...other])];
    }
    return all;
  };
  const one = (): string[] | null => {
    if (take("(")) {
      const inner = either();
      return take(")") ? inner : null;
    }
    const word = words[at++] ?? "";
    return ALLOWED.includes(word) ? [word] : null;
  };
  const found = either();
  if (!found || at < words.length)
    throw new Error(`The licence "${expression}" is none of those that Frond ships: ${ALLOWED.join(", ")}`);
  return found;
}

interface Metadata {
  packages: {
    id: string;
    name: string;
    version: string;
    license: string | null;
    repository: string | null;
    source: string | null;
    manifest_path: string;
    targets: { kind: string[] }[];
  }[];
  resolve: { nodes: { id: string; deps: { pkg: string; dep_kinds: { kind: string | null }[] }[] }[] };
}

/** The crates of others in the modules; what only helps to compile them is not shipped. */
export function crates(): Part[] {
  const options = ["--format-version", "1", "--locked", "--filter-platform", "wasm32-unknown-unknown"];
  const text = execFileSync("cargo", ["metadata", ...options], { cwd: root, maxBuffer: 1 << 28 }).toString();
  const { packages, resolve } = JSON.parse(text) as Metadata;
  const byId = new Map(packages.map((one) => [one.id, one]));
  const uses = new Map(resolve.nodes.map(({ id, deps }) => [id, deps]));
  const seen = new Set<string>();
  const open = packages.filter(({ name, source }) => name === "frond-web" && !source).map(({ id }) => id);
  if (open.length !== 1) throw new Error("Cargo knows no crate frond-web, which the modules are made of.");
  for (let id = open.pop(); id !== undefined; id = open.pop()) {
    if (seen.has(id) || byId.get(id)?.targets.some(({ kind }) => kind.includes("proc-macro"))) continue;
    seen.add(id);
    for (const { pkg, dep_kinds } of uses.get(id) ?? [])
      if (dep_kinds.some(({ kind }) => kind === null)) open.push(pkg);
  }
  return packages
    .filter(({ id, source }) => source && seen.has(id))
    .map(({ name, version, license, repository, manifest_path }) => ({
      name,
      version,
      license: license ?? "",
      source: repository ?? `https://crates.io/crates/${name}`,
      folder: dirname(manifest_path),
    }));
}

interface Lock {
  packages: Record<string, { version?: string; license?: string; dev?: boolean }>;
}

/** The packages of others in the scripts; types are not in them. */
export function scripts(): Part[] {
  const { packages } = JSON.parse(readFileSync(join(root, "package-lock.json"), "utf8")) as Lock;
  return Object.entries(packages)
    .filter(([path, { dev }]) => path !== "" && !dev && !path.includes("node_modules/@types/"))
    .map(([path, { version = "", license = "" }]) => {
      const name = path.replace(/^.*node_modules\//, "");
      return {
        name,
        version,
        license,
        source: `https://www.npmjs.com/package/${name}`,
        folder: join(root, path),
      };
    });
}

/** Who a part is by: the owner of its repository. */
const ownerOf = ({ source }: Part): string => source.split("/").slice(0, 4).join("/");

/** What the files of a part say of the licences it is taken by. */
function texts(part: Part, all: readonly Part[]): string[] {
  const { name, folder, license } = part;
  const ways = chosen(license);
  const files = readdirSync(folder).filter((file) => LICENSE_FILE.test(file));
  const named = files.filter(
    (file) => ways.some((way) => NAMES[way]?.test(file)) || /^(notice|copyright)/i.test(file),
  );
  // A text of the one licence is called just LICENSE.
  const wanted = named.length > 0 ? named : files;
  if (wanted.length > 0) return wanted.map((file) => readFileSync(join(folder, file), "utf8"));
  // Some forget their file. That of Apache names nobody, and so is the same for all.
  if (/Apache-2\.0/.test(license)) return [readFileSync(join(root, "LICENSE-APACHE"), "utf8")];
  // What is by the same owner has the same text.
  for (const other of all.filter((one) => one.license === license && ownerOf(one) === ownerOf(part)))
    for (const file of readdirSync(other.folder).filter((one) => LICENSE_FILE.test(one)))
      return [readFileSync(join(other.folder, file), "utf8")];
  throw new Error(`${name} brings no text of its licence, ${license}`);
}

/** The file: what is shipped, then each text once, with the names of those it is about. */
export function licenseText(parts: readonly Part[]): string {
  const about = new Map<string, string[]>();
  const lines: string[] = [];
  const errors: string[] = [];
  for (const part of [...parts].sort((a, b) => (a.name < b.name ? -1 : a.name > b.name ? 1 : 0))) {
    const { name, version, license, source } = part;
    try {
      for (const text of texts(part, parts)) {
        const same = text.replaceAll("\r\n", "\n").trim();
        about.set(same, [...new Set([...(about.get(same) ?? []), `${name} ${version}`])]);
      }
      lines.push(`${name} ${version}, ${license.replaceAll("/", " OR ")}\n    ${source}`);
    } catch (error) {
      errors.push(`${name} ${version}: ${error instanceof Error ? error.message : error}`);
    }
  }
  if (errors.length > 0) throw new Error(errors.join("\n"));
  const rule = "-".repeat(80);
  const own = ["LICENSE-MIT", "LICENSE-APACHE"].filter((file) => existsSync(join(root, file)));
  return `${[
    "Frond is licensed under MIT OR Apache-2.0, as you choose. It is shipped with parts of others, each under its own\nlicence. Where several are offered, the text of one follows the list.",
    lines.join("\n"),
    "The standard library of Rust, MIT OR Apache-2.0\n    https://github.com/rust-lang/rust",
    ...own.map(
      (file) =>
        `${rule}\nFrond, and the standard library of Rust\n\n${readFileSync(join(root, file), "utf8").trim()}`,
    ),
    ...[...about].map(([text, names]) => `${rule}\n${names.join(", ")}\n\n${text}`),
  ].join("\n\n")}\n`;
}

const ours = () => licenseText([...crates(), ...scripts()]);

/** Adds it to the site that is built. */
export const licenses = {
  name: "licenses",
  apply: "build" as const,
  generateBundle(this: { emitFile(file: { type: "asset"; fileName: string; source: string }): void }) {
    this.emitFile({ type: "asset", fileName: "licenses.txt", source: ours() });
  },
};

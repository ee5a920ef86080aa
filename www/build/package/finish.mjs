/**
 * The last step of the package, when all of its files are there: `node finish.mjs FOLDER`. It writes what follows from
 * them: sizes and hashes in the README and the examples, integrity.json and custom-elements.json. It takes where the
 * project is from FROND_SITE and FROND_REPOSITORY.
 */
import { createHash } from "node:crypto";
import { copyFileSync, existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";
import { customElements } from "./elements.mjs";

const root = fileURLToPath(new URL("../../..", import.meta.url));
/** From there a published package is fetched without being installed. */
const NETWORK = "https://cdn.jsdelivr.net/npm";

/** An address of the web without a slash at its end, or null where none is said. */
function addressOf(variable) {
  const text = process.env[variable];
  if (!text) return null;
  if (!/^https?:\/\/[^/]/i.test(text) || !URL.canParse(text))
    throw new Error(`${variable} is an address such as https://example.org/frond, and not ${text}`);
  return new URL(text).href;
}

/** Where the project is, as npm shows it: only what is known. */
export function whereabouts(site, repository) {
  const sources = repository?.replace(/\/$/, "").replace(/\.git$/, "");
  return {
    ...(site ? { homepage: site } : {}),
    ...(sources
      ? {
          repository: { type: "git", url: `git+${sources}.git` },
          bugs: { url: `${sources}${/^https?:\/\/gitlab\./.test(sources) ? "/-" : ""}/issues` },
        }
      : {}),
  };
}

const hashOf = (bytes) => `sha384-${createHash("sha384").update(bytes).digest("base64")}`;

/** A thousand bytes, and a thousand thousands. */
const told = (bytes) => (bytes < 1e6 ? `${Math.round(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(2)} MB`);

/** A script and all that it imports at once. */
function imported(folder, file, found = new Set()) {
  if (found.has(file)) return found;
  found.add(file);
  const text = readFileSync(join(folder, file), "utf8");
  for (const [, next] of text.matchAll(/^(?:import|export)\b[^"';]*?(?:from\s*)?["']\.\/([\w.-]+\.js)["']/gm))
    imported(folder, next, found);
  return found;
}

/** By their addresses beside integrity.json the hashes of all scripts that a browser may load. */
export function hashes(folder) {
  const scripts = readdirSync(folder).filter((name) => name.endsWith(".js"));
  return Object.fromEntries(
    scripts.sort().map((name) => [`./${name}`, hashOf(readFileSync(join(folder, name)))]),
  );
}

/** What stands in a text as `{{gzip a.wasm + b.wasm}}` and the like. */
export function filled(text, folder, version) {
  const sized = (files) =>
    told(
      files
        .split(" + ")
        .reduce((sum, file) => sum + gzipSync(readFileSync(join(folder, file)), { level: 9 }).length, 0),
    );
  const address = (file) => `${NETWORK}/frond-ifs@${version}/${file}`;
  const WORDS = {
    gzip: sized,
    cdn: address,
    sha384: (file) => hashOf(readFileSync(join(folder, file))),
    hashes: (file) =>
      [...imported(folder, file)]
        .map((name) => `"${address(name)}": "${hashOf(readFileSync(join(folder, name)))}"`)
        .join(",\n      "),
  };
  return text.replace(/\{\{(\w+) ([^{}]+)\}\}/g, (_, word, rest) => {
    const write = WORDS[word];
    if (!write) throw new Error(`the package knows no {{${word} ..}}`);
    return write(rest);
  });
}

/** Finishes a folder that has all else. */
export function finish(folder, { site = null, repository = null } = {}) {
  const at = join(folder, "package.json");
  const manifest = JSON.parse(readFileSync(at, "utf8"));
  const { license, ...rest } = manifest;
  const all = Object.entries(rest);
  // Beside the licence, where one looks for them.
  const where = all.findIndex(([key]) => key === "type");
  const known = { license, ...whereabouts(site, repository) };
  const order = [...all.slice(0, where), ...Object.entries(known), ...all.slice(where)];
  writeFileSync(at, `${JSON.stringify(Object.fromEntries(order), null, 2)}\n`);

  copyFileSync(join(root, "CHANGELOG.md"), join(folder, "CHANGELOG.md"));
  const types = readFileSync(join(folder, "frond-view.d.ts"), "utf8");
  writeFileSync(join(folder, manifest.customElements), `${JSON.stringify(customElements(types), null, 2)}\n`);
  writeFileSync(join(folder, "integrity.json"), `${JSON.stringify(hashes(folder), null, 2)}\n`);
  const examples = join(folder, "examples");
  const written = existsSync(examples) ? readdirSync(examples).map((name) => join(examples, name)) : [];
  for (const file of [join(folder, "README.md"), ...written])
    writeFileSync(file, filled(readFileSync(file, "utf8"), folder, manifest.version));
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [, , folder] = process.argv;
  if (!folder) throw new Error("node finish.mjs FOLDER");
  try {
    finish(folder, { site: addressOf("FROND_SITE"), repository: addressOf("FROND_REPOSITORY") });
  } catch (problem) {
    process.stderr.write(`${problem.message}\n`);
    process.exitCode = 1;
  }
}

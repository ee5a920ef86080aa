/**
 * `sbom.cdx.json` of the site and of the package: what is shipped of others, as CycloneDX, for tools that look for
 * known vulnerabilities. The parts are those of `licenses.txt`; their hashes are those of the two lock files.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { crates, type Part, scripts } from "./licenses.ts";

const root = fileURLToPath(new URL("../..", import.meta.url));
const read = (file: string) => readFileSync(join(root, file), "utf8");

interface Hash {
  alg: "SHA-256" | "SHA-512";
  content: string;
}

/** One part of Frond in the words of CycloneDX. */
interface Component {
  type: "library";
  "bom-ref": string;
  name: string;
  version: string;
  purl: string;
  licenses: [{ expression: string }];
  hashes?: Hash[];
}

/** The hashes of all crates in Cargo.lock: of their archives. */
function crateHashes(): Map<string, Hash> {
  const block =
    /\[\[package\]\]\nname = "(.+)"\nversion = "(.+)"\nsource = ".+"\nchecksum = "([0-9a-f]{64})"/g;
  return new Map(
    [...read("Cargo.lock").matchAll(block)].map(([, name, version, content = ""]) => [
      `${name}@${version}`,
      { alg: "SHA-256", content },
    ]),
  );
}

/** Those of all packages in package-lock.json, which writes them in another form. */
function scriptHashes(): Map<string, Hash> {
  const { packages } = JSON.parse(read("package-lock.json")) as {
    packages: Record<string, { version?: string; integrity?: string }>;
  };
  return new Map(
    Object.entries(packages).flatMap(([path, { version, integrity }]): [string, Hash][] => {
      const [, bytes] = /^sha512-(\S+)$/.exec(integrity ?? "") ?? [];
      if (!bytes) return [];
      const content = Buffer.from(bytes, "base64").toString("hex");
      return [[`${path.replace(/^.*node_modules\//, "")}@${version}`, { alg: "SHA-512", content }]];
    }),
  );
}

function component(kind: "cargo" | "npm", part: Part, hashes: Map<string, Hash>): Component {
  const { name, version, license } = part;
  const hash = hashes.get(`${name}@${version}`);
  // What begins with an at sign is the owner of a package.
  const purl = `pkg:${kind}/${name.replace(/^@/, "%40")}@${version}`;
  return {
    type: "library",
    "bom-ref": purl,
    name,
    version,
    purl,
    licenses: [{ expression: license.replaceAll("/", " OR ") }],
    ...(hash ? { hashes: [hash] } : {}),
  };
}

/** The file. It names no time, so that the same sources make the same bytes. */
export function sbom(): string {
  const { version } = JSON.parse(read("package.json")) as { version: string };
  const [inCargo, inNpm] = [crateHashes(), scriptHashes()];
  const components = [
    ...crates().map((part) => component("cargo", part, inCargo)),
    ...scripts().map((part) => component("npm", part, inNpm)),
  ].sort((a, b) => (a.purl < b.purl ? -1 : 1));
  const own = {
    type: "application",
    "bom-ref": "frond",
    name: "frond",
    version,
    licenses: [{ expression: "MIT OR Apache-2.0" }],
  };
  const bom = {
    $schema: "http://cyclonedx.org/schema/bom-1.6.schema.json",
    bomFormat: "CycloneDX",
    specVersion: "1.6",
    version: 1,
    metadata: { component: own },
    components,
  };
  return `${JSON.stringify(bom, null, 2)}\n`;
}

/** Adds it to the site that is built. */
export const bill = {
  name: "sbom",
  apply: "build" as const,
  generateBundle(this: { emitFile(file: { type: "asset"; fileName: string; source: string }): void }) {
    this.emitFile({ type: "asset", fileName: "sbom.cdx.json", source: sbom() });
  },
};

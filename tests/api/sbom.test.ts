/** The bill of materials: what is shipped, each part as registries know it. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";
import { crates, scripts } from "../../www/build/licenses";
import { sbom } from "../../www/build/sbom";

const root = fileURLToPath(new URL("../..", import.meta.url));

interface Component {
  name: string;
  purl: string;
  licenses: { expression: string }[];
  hashes?: { alg: string; content: string }[];
}

it("lists the parts that licences are kept of, once, with the hashes of the lock files", () => {
  const text = sbom();
  const { bomFormat, components } = JSON.parse(text) as { bomFormat: string; components: Component[] };
  expect(bomFormat).toBe("CycloneDX");
  expect(components).toHaveLength(crates().length + scripts().length);
  expect(new Set(components.map(({ purl }) => purl)).size).toBe(components.length);
  const lock = readFileSync(join(root, "Cargo.lock"), "utf8");
  for (const { purl, licenses, hashes } of components) {
    expect(licenses[0]?.expression, purl).toMatch(/^[\w.()-]+( (OR|AND) [\w.()-]+)*$/);
    const [hash] = hashes ?? [];
    expect(hash?.content, purl).toMatch(purl.startsWith("pkg:cargo/") ? /^[0-9a-f]{64}$/ : /^[0-9a-f]{128}$/);
    if (purl.startsWith("pkg:cargo/")) expect(lock).toContain(`checksum = "${hash?.content}"`);
  }
  const purls = components.map(({ purl }) => purl.replace(/@[\d.]+$/, ""));
  for (const wanted of [
    "pkg:cargo/wgpu",
    "pkg:cargo/num-bigint",
    "pkg:npm/preact",
    "pkg:npm/%40preact/signals",
  ])
    expect(purls).toContain(wanted);
  for (const unwanted of ["pkg:cargo/syn", "pkg:npm/vite", "pkg:cargo/frond-core"])
    expect(purls).not.toContain(unwanted);
  // The same sources make the same bytes.
  expect(sbom()).toBe(text);
});

it("has the hash that a package has in its lock file, in hexadecimal", () => {
  const { components } = JSON.parse(sbom()) as { components: Component[] };
  const { packages } = JSON.parse(readFileSync(join(root, "package-lock.json"), "utf8"));
  const preact = components.find(({ name }) => name === "preact");
  const bytes = Buffer.from(preact?.hashes?.[0]?.content ?? "", "hex").toString("base64");
  expect(`sha512-${bytes}`).toBe(packages["node_modules/preact"].integrity);
});

/** What the package says of itself to editors, catalogues and npm. */
import { readFileSync } from "node:fs";
import { expect, it, vi } from "vitest";
import { customElements } from "../../www/build/package/elements.mjs";
import { filled, whereabouts } from "../../www/build/package/finish.mjs";
import { FrondView } from "../../www/src/element/element";

// Its worker is a program of its own, which only the build makes.
vi.mock("../../www/src/element/pool", () => ({ Pool: class {} }));

const read = (path: string) => readFileSync(new URL(`../../${path}`, import.meta.url), "utf8");
const DECLARED = read("crate/xtask/src/package/entries/frond-view.d.ts");

interface Named {
  name: string;
  description?: string;
  default?: string;
  attribute?: string;
  type?: { text: string };
}
interface Declared {
  attributes: Named[];
  members: Named[];
  events: Named[];
  cssParts: Named[];
  cssProperties: Named[];
}

const declared = (): Declared =>
  (customElements(DECLARED) as unknown as { modules: { declarations: Declared[] }[] }).modules[0]
    ?.declarations[0] as Declared;
const names = (list: Named[]) => list.map(({ name }) => name).sort();

it("custom-elements.json names all that the element has, and describes it", () => {
  const { attributes, members, events, cssParts, cssProperties } = declared();
  expect(names(attributes)).toEqual([...FrondView.observedAttributes].sort());
  // What the class has itself, besides what the browser calls.
  const own = [FrondView.prototype, Object.getPrototypeOf(FrondView.prototype)]
    .flatMap((prototype) => Object.getOwnPropertyNames(prototype))
    .filter((name) => !/^(?:constructor|write|\w+Callback)$/.test(name));
  expect(names(members)).toEqual([...new Set([...own, "proof"])].sort());
  expect(members.flatMap(({ attribute }) => attribute ?? []).sort()).toEqual(names(attributes));
  const shadow = read("www/src/element/shadow.ts");
  const parts = [
    ...shadow.matchAll(/make\("\w+", "(\w+)"\)|classed\("\w+", "\w+", "(\w+)"\)|"part", "(\w+)"/g),
  ].map(([, ...found]) => found.find((part) => part));
  expect(names(cssParts)).toEqual(parts.sort());
  const written = `${read("www/src/style/element.css")}${read("www/src/element/element.ts")}`;
  expect(names(cssProperties)).toEqual([...new Set(written.match(/--frond-\w+/g))].sort());
  const radius = cssProperties.find(({ name }) => name === "--frond-radius");
  expect(written).toContain(`var(--frond-radius, ${radius?.default})`);
  const sent = read("www/src/element/element.ts").matchAll(/#send\("(\w+)"/g);
  expect(names(events)).toEqual([...new Set([...sent].map(([, name]) => name))].sort());
  for (const one of [...attributes, ...members, ...events, ...cssParts, ...cssProperties])
    expect(one.description, one.name).toMatch(/^[A-Z].*\.$/);
});

it("custom-elements.json has types in words of markup", () => {
  const types = Object.fromEntries(declared().attributes.map(({ name, type }) => [name, type?.text]));
  expect(types).toMatchObject({
    a: "string",
    t: "number",
    loop: "boolean",
    theme: '"light" | "dark" | "auto"',
  });
  expect(() => customElements(DECLARED.replace("  a?: Shape", "  a: Shape"))).toThrow("is no attribute");
});

it("npm is told where the project is, as far as it is known", () => {
  expect(whereabouts(null, null)).toEqual({});
  expect(whereabouts("https://example.org/frond/", "https://codeberg.org/x/frond.git")).toEqual({
    homepage: "https://example.org/frond/",
    repository: { type: "git", url: "git+https://codeberg.org/x/frond.git" },
    bugs: { url: "https://codeberg.org/x/frond/issues" },
  });
  expect(whereabouts(null, "https://gitlab.com/x/frond/").bugs?.url).toBe(
    "https://gitlab.com/x/frond/-/issues",
  );
});

it("a text of the package asks for nothing that the build does not know", () => {
  expect(() => filled("{{size frond_bg.wasm}}", ".", "1.0.0")).toThrow("{{size ..}}");
});

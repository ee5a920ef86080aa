/** The pages that unfold where a link is sent: each shape, figure and lesson has one. */
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { runInNewContext } from "node:vm";
import { brotliDecompressSync, gunzipSync } from "node:zlib";
import { beforeAll, describe, expect, it } from "vitest";
import type { MapRow } from "../../crate/web/src/api";
import { PROGRAMS } from "../../www/build/elsewhere/ways";
import { figurePictures } from "../../www/build/figure-pictures";
import { listedFigures } from "../../www/build/figures";
import { type SiteFile, siteOf, sitePages } from "../../www/build/pages";
import { type Drawer, drawer } from "../../www/build/pictures";
import { UNITS } from "../../www/src/figures/lessons/course";
import { ROWS } from "../../www/src/figures/list";

const DOT = new Uint8Array(1);
let drawing: Drawer;
let files: (site: string) => SiteFile[];

describe("the pages of the site", () => {
  beforeAll(async () => {
    // Each picture takes a while: one is drawn below.
    drawing = { ...(await drawer()), picture: () => DOT };
    files = (site) => sitePages(site, drawing);
  });

  const text = (all: SiteFile[], name: string) =>
    String(all.find(({ fileName }) => fileName === name)?.source);

  it("are one for each figure that the list names", () => {
    const listed = [...ROWS, ...UNITS].flatMap(({ figures }) =>
      figures.map(({ id, number, title, about }) => ({ id, number, title, about })),
    );
    expect(listedFigures()).toEqual(listed);
    const names = files("").map(({ fileName }) => fileName);
    for (const { id } of listed) expect(names).toContain(`figure/${id}.html`);
    // Each has a picture of its own, and there is none of a figure that is not there any more.
    const drawn = figurePictures(drawing);
    expect(Object.keys(drawn).sort()).toEqual(listed.map(({ id }) => id).sort());
    expect(new Set(Object.values(drawn).map((picture) => JSON.stringify(picture))).size).toBe(listed.length);
    expect(names).toContain("shape/fern.html");
    expect(names).not.toContain("sitemap.xml");
    expect(new Set(names).size).toBe(names.length);
  });

  it("run the very lines that they show", () => {
    const page = text(files("https://example.org/frond/"), "elsewhere.html");
    const shown = [...page.matchAll(/<code>(.*?)<\/code><\/pre>\s*<div class="live">(.*?)<\/div>\n/gs)];
    expect(shown.length).toBe(9);
    const plain = (html = "") =>
      html.replaceAll("&lt;", "<").replaceAll("&gt;", ">").replaceAll("&quot;", '"').replaceAll("&amp;", "&");
    const here = (code: string) => code.replaceAll("https://example.org/frond", ".");
    const ways = { markup: 0, frame: 0, program: 0 };
    for (const [, code, live = ""] of shown) {
      const lines = here(plain(code)).replace(/<script.*<\/script>/, "");
      const name = /src="\.\/elsewhere\/(\w+)\.js"/.exec(live)?.[1];
      if (name) {
        expect(PROGRAMS[name as keyof typeof PROGRAMS]).toBe(lines);
        ways.program++;
      } else if (live.includes(lines.trim())) ways.markup++;
      else {
        const addresses = [...live.matchAll(/<iframe src="([^"]*)"/g)].map(([, address]) => plain(address));
        expect(addresses.length).toBeGreaterThan(0);
        for (const address of addresses) expect(plain(lines)).toContain(`"${address}"`);
        ways.frame++;
      }
    }
    expect(ways).toEqual({ markup: 4, frame: 2, program: 3 });
  });

  it("name nothing that is not there, wherever the site is", () => {
    for (const site of ["", "https://example.org/frond/"]) {
      const all = files(site);
      // What the rest of the build makes.
      const programs = Object.keys(PROGRAMS).map((name) => `elsewhere/${name}.js`);
      const built = ["", "index.html", "embed.html", "frond-view.js", "api/api.js", ...programs];
      const names = new Set([...all.map(({ fileName }) => fileName), ...built]);
      for (const { fileName, source } of all) {
        if (!fileName.endsWith(".html") || fileName === "404.html") continue;
        // What stands in samples is text.
        const html = String(source).replace(/<code>.*?<\/code>/gs, "");
        const named = [...html.matchAll(/(?:src|href|poster|content)="([^"#]*)(?:#[^"]*)?"/g)]
          .map(([, address = ""]) => address)
          .filter((address) => /^(\.|https:)/.test(address));
        expect(named.length).toBeGreaterThan(2);
        for (const address of named) {
          const path = address.startsWith("https:")
            ? address.replace(site, "")
            : new URL(address, `https://here/${fileName}`).pathname.slice(1);
          expect(names, `${fileName}: ${address}`).toContain(path);
        }
      }
    }
  });

  it("unfold with a title, a sentence and a picture, whose address is whole where the site's is known", () => {
    const fern = text(files("https://example.org/frond/"), "shape/fern.html");
    for (const tag of [
      '<link rel="canonical" href="https://example.org/frond/shape/fern.html" />',
      '<meta property="og:title" content="Fern" />',
      '<meta property="og:image" content="https://example.org/frond/shape/fern.png" />',
      '<a href="../index.html#a=fern&amp;b=fern">',
    ])
      expect(fern).toContain(tag);
    expect(text(files("https://example.org/frond/"), "sitemap.xml")).toContain("/figure/e1.html</loc>");
    expect(text(files(""), "shape/fern.html")).not.toContain("canonical");
    expect(siteOf("https://example.org/frond")).toBe("https://example.org/frond/");
    expect(siteOf("https://example.org/a/?x#y")).toBe("https://example.org/a/");
    expect(siteOf(undefined)).toBe("");
    for (const wrong of ["example.org", "ftp://example.org/"])
      expect(() => siteOf(wrong)).toThrow("FROND_SITE");
  });

  it("lead back from whatever address a host does not know, and to the morph where its # was written as %23", () => {
    const page = text(files(""), "404.html");
    // It is shown at any address: a relative one would lead elsewhere.
    expect(page).not.toMatch(/ src=|<link/);
    const [, script = ""] = /<script>(.*)<\/script>/s.exec(page) ?? [];
    const led = (address: string) => {
      const anchor = { href: "./" };
      const { origin, pathname, search } = new URL(address);
      runInNewContext(script, {
        document: { querySelector: () => anchor },
        location: { origin, pathname, search },
      });
      return anchor.href;
    };
    const site = "https://example.org/frond/";
    for (const lost of ["shape/nope.html", "nope.html", "figure/", "assets/old-1234.js", "shape/a/b.html"])
      expect(led(site + lost)).toBe(site);
    expect(led("https://example.org/nope")).toBe("https://example.org/");
    for (const mangled of ["%23a=fern&b=tree", "index.html%23a=fern&b=tree", "?utm_source=x%23a=fern&b=tree"])
      expect(led(site + mangled)).toBe(`${site}#a=fern&b=tree`);
    expect(led(`${site}embed.html%23a=fern`)).toBe(`${site}embed.html#a=fern`);
    expect(led("https://example.org//evil.example/%23x")).toBe("https://example.org//evil.example/#x");
    expect(text(files(site), "404.html")).toContain(`href="${site}"`);
  });

  it("lie packed beside themselves for hosts that send those, and unpack to what they are", async () => {
    const folder = mkdtempSync(join(tmpdir(), "frond-packed-"));
    mkdirSync(join(folder, "assets"));
    const text = "a morph in one piece; ".repeat(200);
    const names = ["index.html", "assets/page.js", "assets/frond_bg.wasm"];
    for (const name of names) writeFileSync(join(folder, name), text);
    for (const name of ["fern.png", "gone.js.br"]) writeFileSync(join(folder, name), text);
    writeFileSync(join(folder, "small.css"), "a{}");
    execFileSync(process.execPath, [
      fileURLToPath(new URL("../../www/build/packed.mjs", import.meta.url)),
      folder,
    ]);
    const made = readdirSync(folder, { recursive: true })
      .map(String)
      .filter((name) => /\.(br|gz)$/.test(name));
    expect(made.sort()).toEqual(names.flatMap((name) => [`${name}.br`, `${name}.gz`]).sort());
    for (const name of names) {
      expect(brotliDecompressSync(readFileSync(join(folder, `${name}.br`))).toString()).toBe(text);
      expect(gunzipSync(readFileSync(join(folder, `${name}.gz`))).toString()).toBe(text);
    }
    rmSync(folder, { recursive: true });
  });

  it("have pictures of the shape, as PNG", async () => {
    const { picture, shapes } = await drawer();
    const png = Buffer.from(
      picture([{ maps: (shapes()[0]?.maps ?? []) as MapRow[] }], { width: 120, height: 63 }, 0.1),
    );
    expect(png.subarray(1, 4).toString()).toBe("PNG");
    expect([png.readUInt32BE(16), png.readUInt32BE(20)]).toEqual([120, 63]);
    expect(png.length).toBeGreaterThan(500);
  });
});

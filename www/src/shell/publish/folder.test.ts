import { describe, expect, it } from "vitest";
import { indexPage, type Publication, readme, studioOf } from "./folder";

const HOSTILE = `"><script>alert(1)</script><img src=x onerror='a()'>&lt;b&gt;`;
const plain: Publication = {
  title: "Fern to Maple",
  about: "A fern becomes a leaf.",
  address: "https://frond.example/app/?play#a=fern&b=maple&a-name=A%22%3E",
  home: null,
  moves: "still",
  film: null,
};

describe("a published folder", () => {
  it("has nothing of a document's but as text", () => {
    const address = `https://frond.example/#a=fern&a-name="><script>alert(1)</script>`;
    const home = `https://example.org/"><script>alert(1)</script>/`;
    const all = { ...plain, title: HOSTILE, about: HOSTILE, address, home };
    const html = indexPage({ ...all, film: { name: "film.mp4", width: 960, height: 504 } });
    const sober = indexPage({
      ...plain,
      home: "https://example.org/",
      film: { name: "film.mp4", width: 960, height: 504 },
    });
    // As many tags as without it, and each of the same name.
    const tags = (text: string) => [...text.matchAll(/<\/?[a-z-]+/g)].map(([tag]) => tag);
    expect(tags(html)).toEqual(tags(sober));
    // And as many quotes: nothing ends an attribute early.
    expect(html.split('"').length).toBe(sober.split('"').length);
    expect(html).toContain("&lt;script&gt;");
    expect(html).toContain("&amp;lt;b&amp;gt;");
  });

  it("shows the document, and leads to the studio that it comes from", () => {
    const html = indexPage(plain);
    expect(html).toContain('src="https://frond.example/app/?play#a=fern&amp;b=maple&amp;a-name=A%22%3E"');
    expect(html).toContain('studio="https://frond.example/app/"');
    expect(html).not.toContain("autoplay");
    expect(indexPage({ ...plain, moves: "on" })).toContain(" controls autoplay loop>");
    expect(indexPage({ ...plain, moves: "once" })).toContain(" controls autoplay>");
    expect(studioOf("http://localhost:4700/index.html?a=b/c#d/e")).toBe("http://localhost:4700/");
  });

  it("is light or dark as its address says", () => {
    expect(indexPage(plain)).toContain('theme="auto"');
    const dark = indexPage({ ...plain, address: "https://frond.example/app/?play&theme=dark#a=fern" });
    expect(dark).toContain('theme="dark"');
    expect(dark).toContain('<meta name="color-scheme" content="dark" />');
    const none = indexPage({ ...plain, address: "https://frond.example/app/?theme=%22%3E#a=fern" });
    expect(none).toContain('theme="auto"');
  });

  it("names whole addresses only where it is known where it will be", () => {
    expect(indexPage(plain)).not.toMatch(/canonical|og:image|og:url/);
    const html = indexPage({ ...plain, home: "https://example.org/fern/" });
    expect(html).toContain('<link rel="canonical" href="https://example.org/fern/" />');
    expect(html).toContain('<meta property="og:image" content="https://example.org/fern/picture.png" />');
    expect(html).not.toContain("og:video");
  });

  it("says in three lines what to do with it", () => {
    for (const home of [null, "https://example.org/fern/"]) {
      const text = readme({ ...plain, home, film: { name: "film.gif", width: 480, height: 252 } });
      expect(text.trimEnd().split("\n")).toHaveLength(3);
      expect(text).toContain("film.gif");
    }
  });
});

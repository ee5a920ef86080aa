import { describe, expect, it } from "vitest";
import { escaped, folderAddress } from "./html";

describe("text in a page", () => {
  it("is never markup", () => {
    expect(escaped(`<b title="x">&amp;</b>`)).toBe("&lt;b title=&quot;x&quot;&gt;&amp;amp;&lt;/b&gt;");
  });

  it("is an address of a folder only on the web", () => {
    expect(folderAddress("https://example.org/frond")).toBe("https://example.org/frond/");
    expect(folderAddress("https://example.org/a/index.html?x=a/b#y")).toBe("https://example.org/a/");
    expect(folderAddress("https://example.org")).toBe("https://example.org/");
    for (const wrong of [
      "",
      "example.org",
      "ftp://example.org/",
      "javascript:alert(1)",
      "http:/bad",
      "https:///x",
    ])
      expect(folderAddress(wrong)).toBeNull();
  });
});

import { describe, expect, it } from "vitest";
import { momentOf, wishOf } from "./wish";

const wish = (attributes: Record<string, string>) => wishOf((name) => attributes[name] ?? null);

describe("what a <frond-view> asks for", () => {
  it("is a link, however much of it is given", () => {
    const fragment = "v=1&a=fern&b=tree&t=0.5";
    for (const src of [fragment, `#${fragment}`, `https://example.org/frond/#${fragment}`, ` #${fragment} `])
      expect(wish({ src })).toEqual({ fragment, where: "here" });
  });

  it("is put together from shapes and a path", () => {
    expect(wish({ a: "fern" }).fragment).toBe("a=fern&b=fern");
    expect(wish({ a: "fern", b: "tree", path: "0.1,0.8; 0.4 1.2 0.1" }).fragment).toBe(
      "a=fern&b=tree&path=drawn:0.1,0.8;0.4,1.2,0.1",
    );
    expect(wish({ a: "[[0.5,0,0,0.5,0,0],[0.5,0,0,0.5,0.5,1e-7]]", b: "koch", path: "auto" }).fragment).toBe(
      "a=maps:0.5,0,0,0.5,0,0;0.5,0,0,0.5,0.5,1e-7&b=koch&path=auto",
    );
    expect(wish({ a: '{"maps": [[0.5,0,0,0.5,0,0]]}' }).fragment).toContain("a=maps:0.5,0,0,0.5,0,0&");
    // What is said beside a link holds.
    expect(wish({ src: "#a=maps:0,0,0,0,0,0&a-name=Mine&b=tree", a: "koch" }).fragment).toBe("a=koch&b=tree");
  });

  it("goes to the studio where only that shows it", () => {
    for (const src of [
      "#tool=space&space=1",
      "#a=fern&curve-a=maple&curve-b=oak",
      "#a=fern&directed-a=sun&directed-b=quilt",
      "#locus=m",
      "#a=fern&at=0,1",
    ])
      expect(wish({ src }).where, src).toBe("studio");
    expect(wish({ a: "fern", locus: "" }).where).toBe("studio");
    expect(wish({ a: "fern", tool: "deform" })).toEqual({
      fragment: "a=fern&b=fern&tool=deform",
      where: "studio",
    });
    expect(wish({ src: "#a=fern&locus=morph:0,0,2" }).where).toBe("here");
    for (const fragment of ["figures/7", "learn/e1"]) {
      expect(wish({ src: `https://example.org/#${fragment}` })).toEqual({ fragment, where: "figure" });
      expect(wish({ src: fragment })).toEqual({ fragment, where: "figure" });
    }
  });

  it("is refused in words that say what to do", () => {
    for (const [attributes, words] of [
      [{}, "Give src"],
      [{ src: "https://example.org/" }, "src is a link"],
      [{ src: "javascript:alert(1)" }, "src is a link"],
      [{ a: "<img>" }, "a is the name"],
      [{ a: "[[1,2,3]]" }, "a is the name"],
      [{ a: "[[1,2,3,4,5,null]]" }, "a is the name"],
      [{ a: `[${new Array(65).fill("[0,0,0,0,0,0]").join()}]` }, "at most 64"],
      [{ a: "fern", b: "null" + "!" }, "b is the name"],
      [{ a: "fern", path: "there" }, "path is auto"],
      [{ a: "fern", path: "1;2" }, "path is auto"],
      [{ a: "fern", tool: "hammer" }, "tool is one of"],
    ] as const)
      expect(() => wish(attributes), JSON.stringify(attributes)).toThrow(words);
    expect([null, "", "0.25", "7", "-1"].map(momentOf)).toEqual([null, null, 0.25, 1, 0]);
    expect(() => momentOf("soon")).toThrow("t is a number");
  });
});

import { describe, expect, it } from "vitest";
import { lightTroubles } from "./light";
import { mapsTextOf, meansOn, pathTextOf, textOf } from "./values";
import { momentOf, wishOf } from "./wish";

const wish = (attributes: Record<string, string>) => wishOf((name) => attributes[name] ?? null);

describe("what a <frond-view> asks for", () => {
  it("is a link, however much of it is given", () => {
    const fragment = "v=1&a=fern&b=tree&t=0.5";
    for (const src of [fragment, `#${fragment}`, `https://example.org/frond/#${fragment}`, ` #${fragment} `])
      expect(wish({ src })).toEqual({ fragment, where: "here", troubles: [] });
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
      troubles: [],
    });
    expect(wish({ src: "#a=fern&locus=morph:0,0,2" }).where).toBe("here");
    for (const fragment of ["figures/7", "learn/e1"]) {
      expect(wish({ src: `https://example.org/#${fragment}` })).toEqual({
        fragment,
        where: "figure",
        troubles: [],
      });
      expect(wish({ src: fragment })).toEqual({ fragment, where: "figure", troubles: [] });
    }
  });

  it("takes maps however they are written, as text or by a property", () => {
    const rows = [
      [0.5, 0, 0, 0.5, 0, 0],
      [0.5, 0.1, 0.2, 0.4, 0.5, 1e-7],
    ];
    const matrices = rows.map(([a, b, c, d, e, f]) => [
      [a, b, e],
      [c, d, f],
    ]);
    const word = "a=maps:0.5,0,0,0.5,0,0;0.5,0.1,0.2,0.4,0.5,1e-7&";
    for (const maps of [
      rows,
      rows.map((row) => Float64Array.from(row)),
      rows.flat(),
      Float64Array.from(rows.flat()),
      matrices,
      matrices.map((matrix) => [...matrix, [0, 0, 1]]),
      { maps: rows },
    ])
      expect(wish({ a: mapsTextOf(maps) ?? "" }).fragment).toContain(word);
    for (const maps of [
      [1, 2, 3],
      [[1, 2, 3, 4, 5, Number.NaN]],
      [[[1, 2, 3]]],
      [
        [
          [1, 2, 3],
          [1, 2, 3],
          [0, 0, 2],
        ],
      ],
      [],
      {},
      new Date(0),
    ])
      expect(() => wish({ a: mapsTextOf(maps) ?? "" }), JSON.stringify(maps)).toThrow("a is the name");
    const round: { self?: unknown } = {};
    round.self = round;
    expect(() => wish({ a: mapsTextOf(round) ?? "" })).toThrow("a is the name");
  });

  it("is written as attributes are, whatever a framework sets a property to", () => {
    expect([null, undefined, false].map(textOf)).toEqual([null, null, null]);
    expect([0.4, "0.4", "", true].map(textOf)).toEqual(["0.4", "0.4", "", "true"]);
    expect([true, "", "true", "controls", 1, {}].map(meansOn)).toEqual(Array(6).fill(true));
    expect([false, null, undefined, "false", " FALSE ", 0, Number.NaN].map(meansOn)).toEqual(
      Array(7).fill(false),
    );
    expect(
      [
        [
          [0.1, 0.8],
          [0.4, 1.2, 0.1],
        ],
        [],
        "auto",
        null,
      ].map(pathTextOf),
    ).toEqual(["0.1,0.8;0.4,1.2,0.1", "straight", "auto", null]);
    // What frameworks write for what is not there is nothing.
    expect(wish({ src: "", a: "fern", b: "", path: "", tool: "" })).toMatchObject({
      fragment: "a=fern&b=fern",
      troubles: [],
    });
    expect(wish({ a: "fern", locus: "false", panel: "false" }).where).toBe("here");
  });

  it("is shown as far as it means something, and the rest is told", () => {
    for (const [attributes, fragment, attribute] of [
      [{ a: "fern", b: "!" }, "a=fern&b=fern", "b"],
      [{ src: "#a=koch&b=tree", a: "<b>" }, "a=koch&b=tree", "a"],
      [{ src: "https://example.org/", a: "fern" }, "a=fern&b=fern", "src"],
      [{ a: "fern", path: "there" }, "a=fern&b=fern", "path"],
      [{ a: "fern", path: "1;2" }, "a=fern&b=fern", "path"],
      [{ a: "fern", tool: "hammer" }, "a=fern&b=fern", "tool"],
    ] as const) {
      const { troubles, ...rest } = wish(attributes);
      expect(rest, JSON.stringify(attributes)).toEqual({ fragment, where: "here" });
      expect(troubles).toMatchObject([{ name: "FrondError", code: "attribute", attribute }]);
      expect(troubles[0]?.message).toMatch(new RegExp(`^${attribute} is `));
    }
    const light = (attributes: Record<string, string>) =>
      lightTroubles((name) => attributes[name] ?? null).map(({ attribute }) => attribute);
    expect(light({ t: "soon", seconds: "long", theme: "blue" })).toEqual(["t", "seconds", "theme"]);
    expect(light({ t: "7", seconds: "900", theme: "dark" })).toEqual([]);
    expect(light({ t: "", seconds: "", theme: "" })).toEqual([]);
  });

  it("is refused in words that say what to do, where nothing is left to be shown", () => {
    for (const [attributes, words] of [
      [{}, "Give src"],
      [{ b: "fern" }, "Give src"],
      [{ src: "https://example.org/" }, "src is a link"],
      [{ src: "javascript:alert(1)" }, "src is a link"],
      [{ a: "<img>" }, "a is the name"],
      [{ a: "[[1,2,3]]" }, "a is the name"],
      [{ a: "[[1,2,3,4,5,null]]" }, "a is the name"],
      [{ a: `[${new Array(65).fill("[0,0,0,0,0,0]").join()}]` }, "at most 64"],
    ] as const)
      expect(() => wish(attributes), JSON.stringify(attributes)).toThrow(words);
    expect([null, "", "0.25", "7", "-1"].map(momentOf)).toEqual([null, null, 0.25, 1, 0]);
    expect(() => momentOf("soon")).toThrow("t is a number");
  });
});

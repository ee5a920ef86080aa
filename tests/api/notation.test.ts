// biome-ignore-all lint/suspicious/noTemplateCurlyInString: these are texts of pages
/** Formulas are MathML from the build on: what is written, what is refused and where, what is filled in later. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { describe, expect, it } from "vitest";
import { mathml } from "../../www/build/mathml";
import { writeFormulas } from "../../www/build/notation";
import { letter, spoken, tex } from "../../www/src/figures/kit/notation/tex";

const written = (source: string) => writeFormulas(source, "page.tsx") ?? "";

/** What a formula becomes when its page runs. */
function run(source: string, values: Record<string, unknown> = {}): unknown {
  return new Function("tex", ...Object.keys(values), `return ${written(source)}`)(
    tex,
    ...Object.values(values),
  );
}

describe("a formula", () => {
  it("becomes MathML, and keeps how it was written", () => {
    expect(run("tex`f_1(x)`")).toEqual({ tex: "f_1(x)", html: mathml("f_1(x)") });
    expect(mathml("f_1")).toBe("<math><msub><mi>f</mi><mn>1</mn></msub></math>");
  });

  it("is found by what it means, not by how it looks in a comment or a text", () => {
    expect(written('const a = "tex`\\\\no`"; // tex`\\no`\nconst b = tex`b`;')).toContain(
      'const a = "tex`\\\\no`"; // tex`\\no`\nconst b = ({tex:"b"',
    );
    expect(writeFormulas("const a = 1;", "page.tsx")).toBeNull();
  });

  it("may stand in an element, among types", () => {
    expect(written("const a = <p>{(1 as number) && <Formula tex={tex`x^2`} />}</p>;")).toContain(
      '<Formula tex={({tex:"x^2",html:"<math><msup>',
    );
  });

  it("that cannot be read ends the build, with its place", () => {
    expect(() => written("const a = 1;\nconst b = tex`\\frac{a`;")).toThrow(/^page\.tsx:2:11: .*\\frac\{a/);
    expect(() => written("\n\n  tex`a \\nonsense`")).toThrow(/^page\.tsx:3:3: .*Unsupported function/);
    expect(() => written("tex``")).toThrow("page.tsx:1:1: A formula is empty.");
  });

  it("that would need styles in its elements is refused, as the policy of the pages would refuse them", () => {
    expect(() => mathml("\\begin{cases} a \\\\ b \\end{cases}")).toThrow("needs styles");
    expect(() => mathml("\\color{red} a")).toThrow("needs styles");
    expect(() => mathml("\\href{https://example.org}{a}")).toThrow();
  });
});

describe("a number that changes", () => {
  it("is filled in, in both", () => {
    expect(run("tex`r = ${r}, n = ${n + 1}`", { r: 0.5, n: 2 })).toEqual({
      tex: "r = 0.5, n = 3",
      html: mathml("r = 0.5, n = 3"),
    });
  });

  it("may be below 0, or an exponent, and stays a number of its own", () => {
    expect(run("tex`2^${k}`", { k: -3 })).toEqual({
      tex: "2^{-3}",
      html: "<math><msup><mn>2</mn><mn>−3</mn></msup></math>",
    });
    expect(run("tex`2, ${k}`", { k: "−1" })).toMatchObject({ tex: "2, -1" });
  });

  it("is no markup", () => {
    expect(run("tex`a ${b}`", { b: "<img>&" })).toMatchObject({
      html: expect.stringContaining("&lt;img>&amp;"),
    });
  });

  it("that is not shown ends the build", () => {
    expect(() => written("tex`a \\phantom{b ${1}}`")).not.toThrow();
    expect(() => written("tex`\\text{at ${1}}`")).toThrow(/page\.tsx:1:1/);
    // Two numbers side by side would be one.
    expect(() => written("tex`2 ${1}`")).toThrow(/as a number of its own/);
  });
});

it("says symbols to those who hear them, and knows single letters without a build", () => {
  expect(spoken({ tex: "k_{b}", html: "" })).toBe("k b");
  expect(letter("δ")).toEqual({ tex: "\\delta", html: "<math><mi>δ</mi></math>" });
  expect(letter("kb")).toBeNull();
  expect(letter("<")).toBeNull();
});

it("never needs what reads TeX while the page runs", () => {
  const root = fileURLToPath(new URL("../../www/src", import.meta.url));
  const files = readdirSync(root, { recursive: true, encoding: "utf8" }).filter((file) =>
    /\.tsx?$/.test(file),
  );
  for (const file of files) expect(readFileSync(join(root, file), "utf8"), file).not.toMatch(/from "temml/);
});

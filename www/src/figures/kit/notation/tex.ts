/** A formula: how it is written in LaTeX, and as MathML, which the build has made of it (www/build/notation.ts). */
export interface Tex {
  readonly tex: string;
  readonly html: string;
}

/** What the build writes in place of the words of a formula: what stands around its numbers. */
interface Written {
  readonly tex: readonly string[];
  readonly html: readonly string[];
}

/** tex`f_1(x) = ${r} x`: a formula, with numbers that may change. */
export function tex(words: TemplateStringsArray | Written, ...values: readonly (number | string)[]): Tex {
  if (!("html" in words)) throw new Error("Formulas are written by the build, and this page is not built.");
  const texts = values.map((value) => String(value));
  // A raised or lowered number of several signs is one group in LaTeX.
  const grouped = texts.map((text, i) =>
    text.length > 1 && /[_^]$/.test(words.tex[i] ?? "") ? `{${text}}` : text,
  );
  return {
    tex: joined(words.tex, grouped).replaceAll("−", "-"),
    html: joined(words.html, texts.map(escaped)),
  };
}

const joined = (parts: readonly string[], between: readonly string[]) =>
  parts.map((part, i) => part + (between[i] ?? "")).join("");

const escaped = (text: string) => text.replaceAll("-", "−").replaceAll("&", "&amp;").replaceAll("<", "&lt;");

/** A symbol as it is said to those who hear it: k_b is "k b". */
export const spoken = ({ tex: text }: Tex) =>
  text
    .replace(/\\|[{}]/g, "")
    .replace(/_/g, " ")
    .trim();

const GREEK: Readonly<Record<string, string>> = {
  α: "\\alpha",
  μ: "\\mu",
  δ: "\\delta",
  ε: "\\varepsilon",
  λ: "\\lambda",
  φ: "\\varphi",
};

/** A single letter, which needs no build; null for anything else. */
export function letter(name: string): Tex | null {
  if (!/^\p{L}$/u.test(name)) return null;
  return { tex: GREEK[name] ?? name, html: `<math><mi>${name}</mi></math>` };
}

/** What is given as a formula, or as the one letter that it is. */
export type Notation = Tex | string;

export const spokenOf = (notation: Notation) => (typeof notation === "string" ? notation : spoken(notation));

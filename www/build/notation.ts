/**
 * Turns what is written as tex`...` into MathML while the page is built: nothing that reads TeX is sent to anybody. An
 * expression, as in tex`r = ${r}`, is a number that changes while the page runs; it is filled in there.
 */
import { relative } from "node:path";
import { parseSync, Visitor } from "vite";
import { mathml } from "./mathml.ts";

/** A slot in TeX, and what becomes of it. */
const slot = (i: number) => `{\\class{slot${i}}{7}}`;
const SLOT = /<mn class="slot(\d+)">7<\/mn>/;

/** The texts around the slots of a formula, of which there are `count`. */
function around(tex: string, count: number): string[] {
  const parts = mathml(tex).split(SLOT);
  const found = parts.filter((_, i) => i % 2 === 1).map(Number);
  if (found.length !== count || found.some((one, i) => one !== i))
    throw new Error(`The formula ${tex} does not show each of its numbers once, as a number of its own.`);
  const texts = parts.filter((_, i) => i % 2 === 0);
  return texts.map((text, i) => `${i > 0 ? "</mn>" : ""}${text}${i < count ? "<mn>" : ""}`);
}

/** The module with its formulas written out; null where there are none. */
export function writeFormulas(code: string, path: string): string | null {
  if (!code.includes("tex`")) return null;
  const { program, errors } = parseSync(path, code);
  // Whoever compiles it says what is wrong, and where.
  if (errors.length > 0) return null;
  const edits: { start: number; end: number; text: string }[] = [];
  new Visitor({
    TaggedTemplateExpression({ start, tag, quasi }) {
      if (tag.type !== "Identifier" || tag.name !== "tex") return;
      const parts = quasi.quasis.map(({ value }) => value.raw);
      const whole = parts.map((part, i) => (i === 0 ? part : slot(i - 1) + part)).join("");
      try {
        const html = around(whole, parts.length - 1);
        const given = quasi.expressions;
        // What stands between the expressions becomes what the function is given; they stay as they are.
        if (given.length === 0) {
          const text = `({tex:${JSON.stringify(whole)},html:${JSON.stringify(html[0])}})`;
          edits.push({ start, end: quasi.end, text });
          return;
        }
        const first = `tex(${JSON.stringify({ tex: parts, html })}`;
        given.forEach((one, i) => {
          const from = i === 0 ? start : (given[i - 1]?.end ?? start);
          edits.push({ start: from, end: one.start, text: `${i === 0 ? first : ""}, (` });
          edits.push({ start: one.end, end: one.end, text: ")" });
        });
        edits.push({ start: given.at(-1)?.end ?? start, end: quasi.end, text: ")" });
      } catch (error) {
        const before = code.slice(0, start).split("\n");
        const place = `${path}:${before.length}:${(before.at(-1)?.length ?? 0) + 1}`;
        throw new Error(`${place}: ${error instanceof Error ? error.message : error}`);
      }
    },
  }).visit(program);
  if (edits.length === 0) return null;
  let written = "";
  let at = 0;
  for (const { start, end, text } of edits.sort((a, b) => a.start - b.start || a.end - b.end)) {
    written += code.slice(at, start) + text;
    at = end;
  }
  return written + code.slice(at);
}

/** Formulas of the page. It comes before whatever takes types and elements out of the text. */
export const notation = {
  name: "notation",
  enforce: "pre" as const,
  transform(code: string, id: string) {
    const [file = ""] = id.split("?");
    if (!/\.tsx?$/.test(file)) return null;
    const written = writeFormulas(code, relative(process.cwd(), file));
    return written === null ? null : { code: written, map: null };
  },
};

/** Formulas as MathML, made while the site is built: what browsers draw themselves, without a script or a font. */
import temml from "temml";

/** What a formula says in TeX as MathML. Throws what is wrong with it. It may be copied: no names but LaTeX’s own. */
export function mathml(tex: string, display = false): string {
  if (tex.trim() === "") throw new Error("A formula is empty.");
  // Only classes may be given, which the places of numbers need.
  const trust = ({ command }: { command: string }) => command === "\\class";
  const options = { displayMode: display, throwOnError: true, trust };
  let written: string;
  try {
    written = temml.renderToString(tex, options);
  } catch (error) {
    // It repeats the formula below the message, with marks that terminals do not show.
    const [first = ""] = String(error instanceof Error ? error.message : error).split("\n");
    throw new Error(`The formula ${tex} cannot be read: ${first.trim().replace(/:$/, "")}`);
  }
  // Its classes need a sheet that is not loaded, and blocks and accents are laid out well without these two styles.
  const plain = written.replace(/ class="(?!slot)[^"]*"| style="(display:block math|math-depth:0);"/g, "");
  // The policy of the built pages lets no style in that stands in an element.
  if (/ style=/.test(plain)) throw new Error(`The formula ${tex} needs styles; write it in another way.`);
  return plain;
}

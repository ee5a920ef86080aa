/** Whether JSON holds maps, an outline or an animation, by its keys and its rows: `tell` hands it on by that. */

/** Keys of GeoJSON and of programs that label pictures: what has one of them may have rows of numbers of any length. */
const OUTLINE =
  /"(coordinates|features|segmentation|shapes|shape_attributes|polygonlabels|geometries)"\s*:|"type"\s*:\s*"Topology"/;
const ANIMATION = /"frond"\s*:\s*"space"|^[\s\S]{0,4096}"(packed|frames)"\s*:/;
const SYSTEMS = /"(maps|systems)"\s*:/;
/** A document of Frond has both ends and the path between. */
const DOCUMENT = [/"a"\s*:/, /"b"\s*:/, /"path"\s*:/];
/** What other programs call lists of maps: as `crate/exchange/src/read/json.rs` has it. */
const LISTS =
  /"(?:transforms|transformations|functions|affines?|matrices|rows|rules|ifs)"\s*:\s*(\[[\s\S]{0,2000})/;
/** Formulas of x and y, matrices with a shift. */
const FORMULAS = /"f?x"\s*:\s*"[^"]*[xy][^"]*"\s*,\s*"f?y"\s*:/;
const MATRIX = /"(matrix|linear|coefs)"\s*:\s*\[[^{}]*\]/;
/** Formulas of x and y in a row; x1 is a name. */
const ROW_OF_FORMULAS = /"(?=[^"]*\d)[-+\u2212*/().,\d\s]*[xy](?!\d)(?:[-+\u2212*/().,\d\s]|[xy](?!\d))*"/;
const ROW_OF_THREE = "\\[\\s*[^[\\],]+,[^[\\],]+,[^[\\],]+\\]\\s*";
/** A list whose first item has two rows of three numbers, or has 0 0 1 as its third. */
const LIST_OF_MATRICES = new RegExp(
  `^\\[\\s*\\[\\s*${ROW_OF_THREE},\\s*${ROW_OF_THREE}(?:,\\s*\\[\\s*0\\s*,\\s*0\\s*,\\s*1\\s*\\]\\s*)?\\]`,
);
/** A list that begins with points, as pairs or by their names. */
const POINTS = /^\[\s*(\[\s*[-+.\deE]+\s*,\s*[-+.\deE]+\s*\]\s*,|\{\s*"(x|lon|lng)"\s*:\s*[-+.\d])/;
const LETTERS = [..."abcdef"].map((letter) => new RegExp(`"${letter}"\\s*:`, "i"));
/** A number, or a formula of numbers in a text. */
const NUMBER = /^"?(?:[-+\u2212√(\d.]|sqrt|cos|sin|pi)[^":]*"?$/;
/** So many rows and objects are looked at. */
const MOST_LOOKED_AT = 50;

/** Null where nothing says what it is. */
export function kindOfJson(text: string): "maps" | "outline" | "animation" | null {
  if (OUTLINE.test(text)) return "outline";
  if (ANIMATION.test(text)) return "animation";
  if (SYSTEMS.test(text) || DOCUMENT.every((key) => key.test(text))) return "maps";
  const list = LISTS.exec(text)?.[1];
  if (list !== undefined) return POINTS.test(list) ? "outline" : "maps";
  const objects = [...text.matchAll(/\{[^{}[\]]*\}/g)].slice(0, MOST_LOOKED_AT);
  if (objects.some(([object]) => LETTERS.every((letter) => letter.test(object)))) return "maps";
  if ([FORMULAS, MATRIX, LIST_OF_MATRICES].some((form) => form.test(text))) return "maps";
  let found: "outline" | null = null;
  for (const { index, 0: row } of [...text.matchAll(/\[[^{}[\]]*\]/g)].slice(0, MOST_LOOKED_AT)) {
    const words = row
      .slice(1, -1)
      .split(/[\s,]+/)
      .filter((word) => word !== "");
    if (ROW_OF_FORMULAS.test(row)) return "maps";
    if (words.length === 0 || !words.every((word) => NUMBER.test(word))) continue;
    // Rows of a list are maps; numbers that have a name are something else.
    if (words.length >= 6 && !/:\s*$/.test(text.slice(0, index))) return "maps";
    found = "outline";
  }
  if (found === null && /"(x|lon|lng)"\s*:\s*[-+.\d]/.test(text)) found = "outline";
  return found;
}

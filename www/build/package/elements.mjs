/**
 * custom-elements.json, by which editors and catalogues know `<frond-view>`. It is made of the declarations, so that
 * the two cannot differ. The form is https://github.com/webcomponents/custom-elements-manifest, 1.0.0.
 */

const TAG = "frond-view";
const DECLARED = "./frond-view.d.ts";
const MODULES = ["frond-view.module.js", "frond-view.js"];

/** In words of markup what an attribute takes: it is text there. */
const AS_ATTRIBUTE = { Switch: "boolean", Shape: "string", Path: "string", "string | URL": "string" };
const NUMBER = "number | string";

/** The text between the braces of what begins so. */
function body(text, head) {
  const [, rest] = text.split(`${head} {\n`);
  if (rest === undefined) throw new Error(`frond-view.d.ts has no "${head}"`);
  return rest.slice(0, rest.indexOf("\n}"));
}

const COMMENT = /\/\*\*([\s\S]*?)\*\//;
const prose = (comment = "") =>
  comment
    .split("\n")
    .map((line) => line.replace(/^\s*\* ?/, "").trim())
    .join(" ")
    .trim();

/** What is declared, one after the other, with the comment before each; what spans lines becomes one. */
function members(text) {
  const found = [];
  const MEMBER = new RegExp(
    `\\s*(?:${COMMENT.source}\\s*)?([^;{(]+(?:\\([\\s\\S]*?\\))?[^;{]*(?:\\{[^}]*\\}[^;]*)*);`,
    "y",
  );
  while (text.slice(MEMBER.lastIndex).trim() !== "") {
    const [whole, comment, code] = MEMBER.exec(text) ?? [];
    if (whole === undefined) throw new Error("frond-view.d.ts has a member of a form that is not known");
    found.push({ description: prose(comment), code: code.replace(/\s+/g, " ").trim() });
  }
  return found;
}

const without = (type) => type.replace(/ \| (?:null|undefined|\(string & \{\}\))/g, "");
const described = (description) => (description ? { description } : {});

function attributesOf(text) {
  return members(body(text, "export interface ViewAttributes")).map(({ description, code }) => {
    const [, name, said] = /^(\w+)\?: (.*)$/.exec(code) ?? [];
    if (!name) throw new Error(`frond-view.d.ts: ${code} is no attribute`);
    const plain = without(said);
    const type = plain === NUMBER ? "number" : (AS_ATTRIBUTE[plain] ?? plain);
    return { name, ...described(description), type: { text: type } };
  });
}

function eventsOf(text) {
  return members(body(text, "export interface ViewEvents")).map(({ description, code }) => {
    const [, name, type] = /^(\w+): (.*)$/.exec(code) ?? [];
    if (!name) throw new Error(`frond-view.d.ts: ${code} is no event`);
    return { name, ...described(description), type: { text: type } };
  });
}

/** `ViewAttributes["a"]` is written out. */
function membersOf(text) {
  const attributes = new Map(
    members(body(text, "export interface ViewAttributes")).map(({ description, code }) => {
      const [, name, type] = /^(\w+)\?: (.*)$/.exec(code) ?? [];
      return [name, { description, type: without(type) }];
    }),
  );
  const fields = new Map();
  const methods = [];
  for (const { description, code } of members(body(text, "export class FrondView extends HTMLElement"))) {
    if (code.startsWith("addEventListener")) continue;
    const [, fixed, way, name, type] =
      /^(static )?(get|set|readonly) (\w+)(?:\(.*?\))?: (.*)$/.exec(code) ??
      /^(static )?(set) (\w+)\(\w+: (.*)\)$/.exec(code) ??
      [];
    if (name) {
      const attribute = fixed ? undefined : attributes.get(name);
      const known = fields.get(name) ?? {
        kind: "field",
        name,
        ...described(description || attribute?.description),
        type: { text: type },
        ...(fixed ? { static: true } : {}),
        ...(attribute ? { attribute: name, reflects: true } : {}),
        ...(way === "readonly" ? { readonly: true } : {}),
      };
      fields.set(name, known);
      continue;
    }
    const [, method, given, answer] = /^(\w+)\((.*)\): (.*)$/.exec(code) ?? [];
    if (!method) throw new Error(`frond-view.d.ts: ${code} is of a form that is not known`);
    const parameters = given
      ? given.split(/, (?=\w+\??:)/).map((one) => {
          const [, parameter, optional, taken] = /^(\w+)(\?)?: (.*)$/.exec(one) ?? [];
          return { name: parameter, type: { text: taken }, ...(optional ? { optional: true } : {}) };
        })
      : [];
    methods.push({
      kind: "method",
      name: method,
      ...described(description),
      ...(parameters.length ? { parameters } : {}),
      return: { type: { text: answer } },
    });
  }
  return [...fields.values(), ...methods];
}

/** What stands in the comment of the class, as `@csspart name - words` and `@cssproperty [name=default] - words`. */
function classComment(text) {
  const before = text.slice(0, text.indexOf("export class FrondView"));
  const lines = before
    .slice(before.lastIndexOf("/**") + 3, before.lastIndexOf("*/"))
    .split("\n")
    .map((line) => line.replace(/^\s*\* ?/, "").trim());
  const tagged = (tag) =>
    lines.flatMap((line) => {
      const [, name, , fallback, description] =
        new RegExp(`^@${tag} \\[?([\\w-]+)(=([^\\]]*))?\\]? - (.*)$`).exec(line) ?? [];
      return name ? [{ name, description, ...(fallback ? { default: fallback } : {}) }] : [];
    });
  return {
    description: lines
      .filter((line) => !line.startsWith("@"))
      .join(" ")
      .trim(),
    cssProperties: tagged("cssproperty"),
    cssParts: tagged("csspart"),
  };
}

/** Of the text of frond-view.d.ts. */
export function customElements(text) {
  const declaration = {
    kind: "class",
    name: "FrondView",
    tagName: TAG,
    customElement: true,
    superclass: { name: "HTMLElement" },
    ...classComment(text),
    attributes: attributesOf(text).map((one) => ({ ...one, fieldName: one.name })),
    members: membersOf(text),
    events: eventsOf(text),
  };
  const here = { name: "FrondView", module: MODULES[0] };
  const defines = { kind: "custom-element-definition", name: TAG, declaration: here };
  return {
    schemaVersion: "1.0.0",
    readme: "README.md",
    modules: [
      {
        kind: "javascript-module",
        path: MODULES[0],
        summary: `The element as a module; its types are in ${DECLARED}.`,
        declarations: [declaration],
        exports: [{ kind: "js", name: "FrondView", declaration: here }, defines],
      },
      {
        kind: "javascript-module",
        path: MODULES[1],
        summary: "The element as a plain script.",
        exports: [defines],
      },
    ],
  };
}

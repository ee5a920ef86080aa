/**
 * The package's modules as they are shipped. wasm-bindgen's bindings become frond_bg.js and the like, beside the
 * modules that they load; what is imported, frond.js, guards each of their functions (`guard.js` of the package), by
 * types that come from the declarations. `lazy.js` has all functions once more, as promises.
 */
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { type Call, type Class, type Declarations, declarations, type Schema } from "./declarations.ts";

/** The entries that are a module each, and those of the renderer, which are no entries themselves. */
export const ENTRIES = [
  ["draw", "frond"],
  ["curve", "frond-curve"],
  ["proof", "frond-proof"],
  ["exact", "frond-exact"],
  ["fit", "frond-fit"],
  ["space", "frond-space"],
  ["exchange", "frond-exchange"],
  ["directed", "frond-directed"],
  ["morph", "frond-morph"],
] as const;
const RENDERERS = ["frond-webgpu", "frond-webgl2"];

/** What every module exports, or none of its own. */
const COMMON = new Set(["start", "initSync", "__wbg_init"]);
/** What the last words of a file are about: the module itself. */
const OF_INIT = /^(?:InitInput|InitOutput|SyncInitInput)$/;

/** So many numbers in a row are better given by their names. */
const MANY_NUMBERS = 4;

/** What is put around a function or a class, besides its guard: by names of `guard.js`. */
const AROUND: Record<string, string> = { decodeScene: "decoding", LinkedMorph: "ofLink" };

const WRITTEN = "// Written by the build, from the declarations of the module: see www/build/package.\n";

interface Module {
  /** Of its entry; empty for the renderer's. */
  entry: string;
  name: string;
  text: string;
  bindings: string;
  found: Declarations;
}

/** Writes all of it, from the folder of wasm-bindgen's files. */
export function ship(from: string, to: string): void {
  mkdirSync(join(to, "node"), { recursive: true });
  const modules = [...ENTRIES, ...RENDERERS.map((name) => ["", name] as const)].map(
    ([entry, name]): Module => {
      const text = readFileSync(join(from, `${name}.d.ts`), "utf8");
      const bindings = readFileSync(join(from, `${name}.js`), "utf8");
      return { entry, name, text, bindings, found: declarations(text) };
    },
  );
  for (const module of modules) {
    writeFileSync(join(to, `${module.name}_bg.js`), bindingsOf(module));
    writeFileSync(join(to, `${module.name}.js`), guardOf(module));
    writeFileSync(join(to, `${module.name}.d.ts`), typesOf(module));
    writeFileSync(join(to, `${module.name}_bg.wasm.d.ts`), 'export { default } from "./wasm.js";\n');
  }
  // The page has the same script, and no class of errors.
  for (const file of ["renderer.js", "renderer.d.ts"]) {
    const text = readFileSync(join(from, file), "utf8");
    writeFileSync(join(to, file), `${text}\nexport { FrondError } from "./guard.js";\n`);
  }
  writeFileSync(join(to, "guard-types.js"), namedTypes(modules));
  const entries = modules.filter(({ entry }) => entry !== "");
  writeFileSync(
    join(to, "lazy.js"),
    lazyOf(entries, (module) => `./${module.name}.js`, "./guard.js"),
  );
  writeFileSync(
    join(to, "node/lazy.js"),
    lazyOf(entries, (module) => `./${module.entry}.js`, "../guard.js"),
  );
  writeFileSync(join(to, "lazy.d.ts"), lazyTypesOf(entries));
}

/**
 * wasm-bindgen's own script. What it made is told apart by the instance that it is of, so that a module can be made
 * anew after it broke: what belongs to the one before is neither called nor freed in the new one.
 */
function bindingsOf({ name, bindings }: Module): string {
  const text = bindings
    .replace(/^\/\* @ts-self-types.*\n/, "")
    .replace(
      /(\w+)Finalization\.register\((\w+), \2\.__wbg_ptr, \2\);/g,
      "$2.__frond = wasm;\n        $1Finalization.register($2, { pointer: $2.__wbg_ptr, of: wasm }, $2);",
    )
    // A list that is told in an error would be told with all of its entries.
    .replace(
      /^function debugString\(val\) \{$/m,
      "$&\n    if (typeof val === 'object' && val !== null) return 'Object';",
    )
    .replace(
      /new FinalizationRegistry\(ptr => wasm\.(\w+)\(ptr, 1\)\)/g,
      "new FinalizationRegistry(({ pointer, of }) => of === wasm && wasm.$1(pointer, 1))",
    );
  if (
    /register\(\w+, \w+\.__wbg_ptr|Registry\(ptr/.test(text) ||
    !/^let wasmModule, wasmInstance, wasm;/m.test(text)
  )
    throw new Error(`the bindings of ${name} are not of the form that is known`);
  return `${text}
export const current = () => wasm;
export function restart() {
    const module = wasmModule;
    wasm = undefined;
    initSync({ module });
}
`;
}

const functionsOf = ({ found }: Module) => byName(found.functions.filter(({ name }) => !COMMON.has(name)));

/** Of those that are declared for several lists of parameters the last, which is for all. */
function byName(calls: Call[]): Call[] {
  return [...new Map(calls.map((call) => [call.name, call])).values()];
}

/** Where four numbers or more follow each other. */
function rowOf({ parameters }: Call): { at: number; count: number } | undefined {
  for (let at = 0; at < parameters.length; at++) {
    let count = 0;
    while (isNumber(parameters[at + count]?.type)) count++;
    if (count >= MANY_NUMBERS) return { at, count };
  }
  return undefined;
}

const isNumber = (type: Schema | undefined) =>
  type === "number" ||
  (typeof type === "object" &&
    "any" in type &&
    type.any.every((one) => one === "number" || one === "nothing"));

function signature(call: Call): object {
  const row = rowOf(call);
  return {
    parameters: call.parameters.map(({ name, optional, type }) => {
      const absent = typeof type === "object" && "any" in type && type.any.includes("nothing");
      const plain = absent && isNumber(type) ? "number" : type;
      return { name, type: plain, ...(optional || absent ? { optional: true } : {}) };
    }),
    ...(row && {
      row: { at: row.at, names: call.parameters.slice(row.at, row.at + row.count).map(({ name }) => name) },
    }),
  };
}

const signatures = (calls: Call[]) => Object.fromEntries(calls.map((call) => [call.name, signature(call)]));

/** The module as it is imported. */
function guardOf(module: Module): string {
  const { entry, name, found } = module;
  const functions = functionsOf(module);
  const names = [...functions.map((call) => call.name), ...found.classes.map((one) => one.name)];
  const around = names.flatMap((each) => AROUND[each] ?? []);
  const put = (each: string, made: string) =>
    AROUND[each] ? `/* @__PURE__ */ ${AROUND[each]}(${made})` : made;
  const renders = RENDERERS.includes(name);
  const lines = [
    `import load, { initSync as loadSync, current, ${renders ? "" : "restart, "}start as started,`,
    ...names.map((each) => `  ${each} as ${each}_,`),
    `} from "./${name}_bg.js";`,
    `import { FrondError, guarded${around.map((each) => `, ${each}`).join("")} } from "./guard.js";`,
    "export { FrondError };",
    // What a renderer hands to the browser calls it in the module that it was made by.
    `const module = /* @__PURE__ */ guarded({ entry: ${JSON.stringify(renders ? "/renderer" : `/${entry}`)}, load, loadSync, current${renders ? "" : ", restart"} });`,
    "export default module.init;",
    "export const initSync = module.initSync;",
    'export const start = /* @__PURE__ */ module.call("start", started, { parameters: [] });',
    ...functions.map(
      (call) =>
        `export const ${call.name} = ${put(
          call.name,
          `/* @__PURE__ */ module.call("${call.name}", ${call.name}_, ${JSON.stringify(signature(call))})`,
        )};`,
    ),
    ...found.classes.map(
      (one) =>
        `export const ${one.name} = ${put(
          one.name,
          `module.type("${one.name}", ${one.name}_, ${JSON.stringify(members(one))})`,
        )};`,
    ),
  ];
  return `${WRITTEN}${lines.join("\n")}\n`;
}

function members({ calls, getters, made }: Class): object {
  const of = (kind: Call["kind"]) => calls.filter((call) => call.kind === kind);
  const [first] = of("constructor");
  return {
    ...(made && { made: first ? signature(first) : { parameters: [] } }),
    calls: signatures(of("method")),
    statics: signatures(of("static")),
    getters,
  };
}

/** The types that parameters are of, by their names. */
function namedTypes(modules: Module[]): string {
  const all = new Map<string, string>();
  for (const { found } of modules) {
    const calls = [...found.functions, ...found.classes.flatMap((one) => one.calls)];
    const open = calls.flatMap(({ parameters }) => parameters.flatMap(({ type }) => namesIn(type)));
    const seen = new Set<string>();
    for (let name = open.pop(); name !== undefined; name = open.pop()) {
      // What is imported is declared by the first of the modules.
      const schema = (found.types.get(name) ?? modules[0]?.found.types.get(name))?.schema;
      if (seen.has(name) || OF_INIT.test(name)) continue;
      seen.add(name);
      if (!schema) throw new Error(`the type ${name} is declared nowhere`);
      const text = JSON.stringify(schema);
      if ((all.get(name) ?? text) !== text) throw new Error(`there are two types ${name}`);
      all.set(name, text);
      open.push(...namesIn(schema));
    }
  }
  const rows = [...all].sort(([a], [b]) => (a < b ? -1 : 1)).map(([name, text]) => `  ${name}: ${text},`);
  return `${WRITTEN}export const types = {\n${rows.join("\n")}\n};\n`;
}

function namesIn(type: Schema): string[] {
  if (typeof type === "string") return [];
  if ("named" in type) return [type.named];
  if ("list" in type) return namesIn(type.list);
  if ("row" in type) return type.row.flatMap(namesIn);
  if ("any" in type) return type.any.flatMap(namesIn);
  if ("all" in type) return type.all.flatMap(namesIn);
  if ("object" in type) return Object.values(type.object).flatMap(namesIn);
  if ("partly" in type) return namesIn(type.partly);
  return "without" in type ? namesIn(type.without) : [];
}

// The declarations.

interface Edit {
  start: number;
  end: number;
  text: string;
}

function edited(text: string, edits: Edit[], from = 0, to = text.length): string {
  let out = "";
  let at = from;
  for (const { start, end, text: put } of edits.toSorted((a, b) => a.start - b.start)) {
    if (start < at || end > to) continue;
    out += text.slice(at, start) + put;
    at = end;
  }
  return out + text.slice(at, to);
}

/** What is given is taken in any form that can be read, and what comes back is nobody else's. */
function editsOf(text: string, call: Call): Edit[] {
  const edits = call.parameters.map(({ at: { start, end }, type, optional }) => {
    const plain = text.slice(start, end);
    const given = isGiven(type) ? `Input<${plain}>` : plain.replaceAll("number[]", "readonly number[]");
    const absent = optional && !/\bnull\b/.test(plain) ? " | null" : "";
    return { start, end, text: `${given}${absent}` };
  });
  return [...edits, { ...call.returns, text: answer(text.slice(call.returns.start, call.returns.end)) }];
}

/** Whether there may be lists or objects in it. */
function isGiven(type: Schema): boolean {
  if (typeof type === "string") return false;
  if ("any" in type)
    return type.any.some(
      (one) => isGiven(one) && !(typeof one === "object" && "list" in one && one.list === "number"),
    );
  return !("instance" in type || "is" in type);
}

const answer = (type: string) =>
  type
    .replace(/\b((?:Int|Uint|Float)\d+(?:Clamped)?Array)\b(?!<)/g, "$1<ArrayBuffer>")
    .replace("problem?: FrondError", "problem?: { code: string; message: string }");

/** The same call with numbers by their names, before the one that takes them in a row. */
function named(text: string, call: Call): string {
  const row = rowOf(call);
  if (!row) return "";
  const part = (from: number, to: number) => call.parameters.slice(from, to);
  const given = (parameters: Call["parameters"]) =>
    parameters.map(({ name, optional, at, type }) => {
      const edits = editsOf(text, { ...call, parameters: [{ name, optional, at, type }] });
      return `${name}${optional ? "?" : ""}: ${edits[0]?.text}`;
    });
  const fields = part(row.at, row.at + row.count).map(({ name, type }) =>
    type === "number" ? `${name}: number` : `${name}?: number | null`,
  );
  const all = [
    ...given(part(0, row.at)),
    `numbers: { ${fields.join("; ")} }`,
    ...given(part(row.at + row.count, call.parameters.length)),
  ];
  const comment = text.slice(call.start, text.indexOf(`${call.name}(`, call.start));
  return `${comment}${call.name}(${all.join(", ")}): ${answer(text.slice(call.returns.start, call.returns.end))};\n    `;
}

function typesOf({ name, text, found }: Module): string {
  const calls = [
    ...found.functions.filter((call) => !COMMON.has(call.name)),
    ...found.classes.flatMap((one) => one.calls),
  ];
  const edits = calls.flatMap((call) => editsOf(text, call));
  for (const call of calls) {
    const put = named(text, call);
    if (put) {
      const old = "/** @deprecated Give the numbers by their names, in one object. */\n    ";
      const signed = text.indexOf(`${call.name}(`, call.start);
      edits.push({ start: call.start, end: signed, text: `${put}${old}` });
    }
  }
  for (const [type, { start, end }] of found.types) {
    if (type === "FrondError") edits.push({ start, end, text: "" });
    // Whoever looks into a module looks for its memory.
    if (type === "InitOutput") {
      const only = "export interface InitOutput {\n    readonly memory: WebAssembly.Memory;\n}";
      edits.push({ start, end, text: only });
    }
  }
  const body = edited(text, edits);
  const taken = /\bInput</.test(body) ? 'import type { Input } from "./guard.js";\n' : "";
  if (/\bany\b/.test(body.replace(/\/\*[\s\S]*?\*\//g, ""))) throw new Error(`${name}.d.ts says any`);
  return `${taken}export { FrondError } from "./guard.js";\n${body}`;
}

// All of it without init.

function lazyOf(modules: Module[], path: (module: Module) => string, guard: string): string {
  const lines = [
    `import { lazily } from "${guard}";`,
    `export { FrondError } from "${guard}";`,
    "const { call, make } = /* @__PURE__ */ lazily({",
    ...modules.map((module) => `  ${module.entry}: () => import("${path(module)}"),`),
    "});",
  ];
  for (const module of modules) {
    for (const { name } of functionsOf(module))
      lines.push(`export const ${name} = /* @__PURE__ */ call("${module.entry}", "${name}");`);
    for (const { name, made } of module.found.classes)
      if (made) lines.push(`export const new${name} = /* @__PURE__ */ make("${module.entry}", "${name}");`);
  }
  return `${WRITTEN}${lines.join("\n")}\n`;
}

function lazyTypesOf(modules: Module[]): string {
  const known = new Set<string>();
  const names: string[] = [];
  const calls: string[] = [];
  for (const module of modules) {
    const { found, text, name } = module;
    const own = [
      ...[...found.types.keys()].filter((type) => type !== "FrondError"),
      ...found.classes.map((one) => one.name),
    ];
    const fresh = own.filter((type) => !OF_INIT.test(type) && !known.has(type));
    for (const type of fresh) known.add(type);
    if (fresh.length > 0) {
      names.push(`import type { ${fresh.join(", ")} } from "./${name}.js";`);
      names.push(`export type { ${fresh.join(", ")} } from "./${name}.js";`);
    }
    for (const call of found.functions) {
      if (COMMON.has(call.name)) continue;
      const edits = editsOf(text, call);
      const returns = edits.pop();
      if (returns) edits.push({ ...returns, text: `Promise<${returns.text}>` });
      calls.push(edited(text, edits, call.start, call.end));
    }
    for (const one of found.classes) {
      if (!one.made) continue;
      const made = one.calls.find(({ kind }) => kind === "constructor");
      const given = made ? edited(text, editsOf(text, made), made.inside.start, made.inside.end) : "";
      calls.push(
        `/** What \`new ${one.name}(..)\` makes. */\nexport function new${one.name}(${given}): Promise<${one.name}>;`,
      );
    }
  }
  return [
    "/** All functions of the other entries, as promises: each module is fetched when something of it is first called. */",
    'import type { Input } from "./guard.js";',
    'export { FrondError } from "./guard.js";',
    ...names,
    "",
    calls.join("\n\n"),
    "",
  ].join("\n");
}

/**
 * The pages of the package's functions, `api/` of the site: one for each entry, one for the types, and one that lists
 * and searches all. They are made of the declarations, and of the samples beside this file, which run on them.
 */
import { existsSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { escaped } from "../../src/format/html.ts";
import { type Declared, declarations, type Member } from "./read.ts";

interface Entry {
  /** Of the page, and of the entry after the slash. */
  name: string;
  about: string;
  file: string;
  /** From a file that declares much else. */
  besides?: { file: string; names: readonly string[] };
}

const BUILT = "www/pkg/";
const WRITTEN = "crate/xtask/src/package/entries/";

const ENTRIES: readonly Entry[] = [
  { name: "draw", about: "The gallery, pictures, morphs and links.", file: `${BUILT}frond.d.ts` },
  {
    name: "proof",
    about: "Whether a shape is in one piece, for which parameters, on which path, and proofs of it.",
    file: `${BUILT}frond-proof.d.ts`,
  },
  { name: "curve", about: "Closed curves and fractal functions.", file: `${BUILT}frond-curve.d.ts` },
  {
    name: "fit",
    about: "Curves and maps fitted to outlines, graphs and pictures.",
    file: `${BUILT}frond-fit.d.ts`,
  },
  { name: "space", about: "Systems of three dimensions.", file: `${BUILT}frond-space.d.ts` },
  {
    name: "directed",
    about: "Shapes of several states, made of copies of each other.",
    file: `${BUILT}frond-directed.d.ts`,
  },
  {
    name: "exact",
    about: "Numbers that formulas mean exactly, proofs about them, and what the neighbours of pieces tell.",
    file: `${BUILT}frond-exact.d.ts`,
  },
  {
    name: "exchange",
    about: "Maps from the files of other programs, and for them.",
    file: `${BUILT}frond-exchange.d.ts`,
  },
  { name: "morph", about: "The morph of a link, and no more.", file: `${BUILT}frond-morph.d.ts` },
  {
    name: "renderer",
    about: "A live picture by WebGPU or WebGL2.",
    file: `${BUILT}renderer.d.ts`,
    besides: {
      file: `${BUILT}frond-webgpu.d.ts`,
      names: ["Renderer", "SpaceRenderer", "LocusCompute"],
    },
  },
  { name: "pool", about: "What takes long, in workers.", file: `${WRITTEN}pool.d.ts` },
  { name: "view", about: "The element &lt;frond-view&gt;.", file: `${WRITTEN}frond-view.d.ts` },
];
/** `frond-ifs` itself has these. */
const MAIN = ["draw", "curve", "proof"];

const fileOf = (path: string) => fileURLToPath(new URL(`../../../${path}`, import.meta.url));

interface Listed extends Entry {
  declared: Declared[];
}

/** All that is declared: functions and classes by their entries, types by themselves, each once. */
export function surface(): { entries: Listed[]; types: Declared[] } {
  const types = new Map<string, Declared>();
  const entries = ENTRIES.map((entry): Listed => {
    const read = (file: string) => declarations(readFileSync(fileOf(file), "utf8"));
    const { file, besides } = entry;
    const more = besides ? read(besides.file).filter(({ name }) => besides.names.includes(name)) : [];
    const all = [...read(file), ...more];
    for (const one of all) if (one.kind === "type" && !types.has(one.name)) types.set(one.name, one);
    return { ...entry, declared: all.filter(({ kind }) => kind !== "type") };
  });
  return { entries, types: [...types.values()].sort((p, q) => (p.name < q.name ? -1 : 1)) };
}

/** The sample of a function, or null. */
export function sampleOf(name: string): string | null {
  const file = fileOf(`www/build/api/samples/${name}.js`);
  return existsSync(file) ? readFileSync(file, "utf8") : null;
}

/** The page that is written around it; `api/` is below the root of the site. */
export interface Page {
  path: string;
  title: string;
  about: string;
  content: string;
}

export const API_STYLE =
  "section{margin-top:2.5rem}section h2,section h3{margin:0;font-size:1rem}h2 code,h3 code{font-size:1.125rem}" +
  "section section{margin:1rem 0 0 1rem}ul.index{padding:0;list-style:none}ul.index li{padding:0.25rem 0}[hidden]{display:none!important}" +
  "form{display:flex;flex-wrap:wrap;gap:0.5rem;align-items:center;margin:1rem 0}" +
  "input[type=search]{flex:1 1 14rem;min-width:0;padding:0.5rem 0.75rem;border:1px solid GrayText;border-radius:0.5rem;background:Field;color:FieldText;font:inherit}" +
  "button{padding:0.4rem 1rem;border:1px solid GrayText;border-radius:0.5rem;background:ButtonFace;color:ButtonText;font:inherit;cursor:pointer}" +
  "pre.signature{white-space:pre-wrap}output{display:block;margin-top:0.5rem;white-space:pre-wrap;font:0.875rem/1.5 ui-monospace,monospace}" +
  ".sample canvas{display:block;width:25rem;max-width:100%;margin-top:0.5rem;image-rendering:pixelated}" +
  ":focus-visible{outline:2px solid Highlight;outline-offset:2px}";

const SEARCH = `<form role="search" hidden><label for="q">Search the functions</label>
        <input type="search" id="q" name="q" autocomplete="off" spellcheck="false" /></form>`;

export function apiPages(): Page[] {
  const { entries, types } = surface();
  const places = new Map<string, string>();
  for (const { name, declared } of entries)
    for (const one of declared) if (!places.has(one.name)) places.set(one.name, `./${name}.html#${one.name}`);
  for (const { name } of types) if (!places.has(name)) places.set(name, `./types.html#${name}`);

  /** Code with its names as links to where they are declared. */
  const linked = (code: string, own = "") =>
    escaped(code).replace(/\b[A-Za-z]\w+\b/g, (name) => {
      const place = name === own ? undefined : places.get(name);
      // In lower case it is as well the name of an argument, or a word.
      return place && /^[A-Z]/.test(name) ? `<a href="${place}">${name}</a>` : name;
    });
  const inline = (text: string, declared = "") =>
    escaped(text).replace(/`([^`]+)`/g, (_, code: string) => {
      const name = code.replace(/\(.*$/, "");
      // What is declared here may have an argument of the same name.
      const place = new RegExp(`\\b${name.replace(/\W/g, "")}\\??:`).test(declared)
        ? undefined
        : places.get(name);
      return place ? `<a href="${place}"><code>${code}</code></a>` : `<code>${code}</code>`;
    });
  const prose = (about: string, declared: string) =>
    about
      .split(/\n{2,}/)
      .filter((paragraph) => paragraph && !paragraph.startsWith("@"))
      .map(
        (paragraph) => `<p>${inline(paragraph.replace(/\n@.*$/gm, "").replaceAll("\n", " "), declared)}</p>`,
      )
      .join("\n");
  const signature = (code: string, own: string) =>
    `<pre class="signature" tabindex="0"><code>${linked(code, own)}</code></pre>`;
  const member = (of: string, { name, about, code }: Member) => `
        <section><h3 id="${of}.${name}"><code>${name}</code></h3>
        ${signature(code, of)}${prose(about, code)}</section>`;
  const sample = (name: string) => {
    const code = sampleOf(name);
    if (code === null) return "";
    return `
        <div class="sample"><pre tabindex="0"><code>${escaped(code.trimEnd())}</code></pre>
        <button type="button" data-sample="${name}" aria-label="Run the sample of ${name}" hidden>Run</button>
        <output></output></div>`;
  };
  const block = (one: Declared) => `
      <section><h2 id="${one.name}"><code>${one.name}</code></h2>
      ${one.kind === "class" && one.members.length > 0 ? "" : signature(one.code, one.name)}
      ${prose(one.about, one.code)}${sample(one.name)}${one.members
        .map((each) => member(one.name, each))
        .join("")}</section>`;

  const first = (about: string) => inline(/^[\s\S]*?\.(?=\s|$)/.exec(about)?.[0].replaceAll("\n", " ") ?? "");
  const row = (place: string, name: string, about: string) =>
    `<li><a href="${place}"><code>${name}</code></a> ${first(about).replace(/<a [^>]*>|<\/a>/g, "")}</li>`;
  const group = (place: string, title: string, about: string, rows: string) => `
      <section><h2><a href="${place}">${title}</a></h2><p>${about}</p><ul class="index">${rows}</ul></section>`;
  const back = `<nav aria-label="All entries"><p><a href="./index.html">All functions</a> · ${[
    ...entries.map(({ name }) => name),
    "types",
  ]
    .map((name) => `<a href="./${name}.html">${name}</a>`)
    .join(" · ")}</p></nav>`;

  const listed = entries.map(({ name, about, declared }) =>
    group(
      `./${name}.html`,
      `frond-ifs/${name}`,
      `${about}${MAIN.includes(name) ? " Also in <code>frond-ifs</code>." : ""}`,
      declared
        .flatMap((one) => [
          row(`./${name}.html#${one.name}`, one.name, one.about),
          ...one.members
            .filter((each) => each.name !== "constructor")
            .map((each) =>
              row(`./${name}.html#${one.name}.${each.name}`, `${one.name}.${each.name}`, each.about),
            ),
        ])
        .join("\n"),
    ),
  );
  const types_ = group(
    "./types.html",
    "Types",
    "What the functions take and give.",
    types.map(({ name, about }) => row(`./types.html#${name}`, name, about)).join("\n"),
  );
  const index: Page = {
    path: "api/index.html",
    title: "Functions of the package",
    about: "All functions, classes and types of frond-ifs, with samples that run on the page.",
    content: `${SEARCH}<p id="found" role="status"></p>
      <p>Each entry begins with <code>init()</code>, which loads its module: <code>import init, { presets } from "frond-ifs/draw"; await init();</code></p>
      ${listed.join("\n")}${types_}`,
  };
  return [
    index,
    ...entries.map(
      ({ name, about, declared }): Page => ({
        path: `api/${name}.html`,
        title: `frond-ifs/${name}`,
        about: about.replaceAll("&lt;", "<").replaceAll("&gt;", ">"),
        content: `${back}${SEARCH}${declared.map(block).join("\n")}`,
      }),
    ),
    {
      path: "api/types.html",
      title: "Types of the package",
      about: "What the functions of frond-ifs take and give.",
      content: `${back}${SEARCH}${types.map(block).join("\n")}`,
    },
  ];
}

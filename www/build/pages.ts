/**
 * What a messenger, a search engine or a browser's home screen sees of the site: a page for each shape, figure and
 * lesson, with a picture that the program made; icons and the manifest. Where the site will be is told by FROND_SITE,
 * for addresses that have to be whole; without it they are relative, and few messengers follow them.
 */
import type { MapRow } from "../../crate/web/src/api";
import { escaped, folderAddress } from "../src/format/html.ts";
import { API_STYLE, apiPages } from "./api/pages.ts";
import { ways } from "./elsewhere/ways.ts";
import { figurePictures } from "./figure-pictures.ts";
import { listedFigures } from "./figures.ts";
import { missingPage } from "./missing.ts";
import { type Drawer, drawer } from "./pictures.ts";
import { policyOf } from "./policy.ts";
import { theorems } from "./theorems.ts";

const NAME = "Frond";
const ABOUT =
  "A studio for shapes made of smaller copies of themselves: morph one fractal into another without letting it fall apart.";
/** Of pictures that unfold, as most messengers want them. */
const UNFOLDED = { width: 1200, height: 630 };
/** Those of figures are many: the same proportions, and still as large as messengers ask for. */
const FIGURE = { width: 640, height: 336 };
const ICONS = [
  { name: "icon-192.png", side: 192, free: 0.06 },
  { name: "icon-512.png", side: 512, free: 0.06 },
  // A system may cut a circle out of it.
  { name: "icon-maskable.png", side: 512, free: 0.2 },
  { name: "apple-touch-icon.png", side: 180, free: 0.1 },
];

interface Described {
  /** From the root of the site. */
  path: string;
  title: string;
  about: string;
  picture: string;
  size?: { width: number; height: number };
}

export interface SiteFile {
  fileName: string;
  source: string | Uint8Array;
}

/** What unfolds where a link to a page is sent. `site` ends with a slash, or is empty. */
export function tags(
  { path, title, about, picture: image, size = UNFOLDED }: Described,
  site: string,
): string {
  const up = "../".repeat(path.split("/").length - 1);
  const whole = (file: string) => escaped(site === "" ? `${up}${file}` || "./" : `${site}${file}`);
  const property = (name: string, content: string) => `<meta property="og:${name}" content="${content}" />`;
  return [
    ...(site === "" ? [] : [`<link rel="canonical" href="${whole(path)}" />`, property("url", whole(path))]),
    property("type", "website"),
    property("site_name", NAME),
    property("title", escaped(title)),
    property("description", escaped(about)),
    property("image", whole(image)),
    property("image:width", String(size.width)),
    property("image:height", String(size.height)),
    '<meta name="twitter:card" content="summary_large_image" />',
    `<link rel="manifest" href="${up}manifest.webmanifest" />`,
    `<link rel="apple-touch-icon" href="${up}apple-touch-icon.png" />`,
  ].join("\n    ");
}

const STYLE =
  "body{max-width:60rem;margin:0 auto;padding:1.5rem;background:Canvas;color:CanvasText;font:1rem/1.5 system-ui,sans-serif}" +
  "frond-view{width:100%;aspect-ratio:16/9}frond-view[src]{aspect-ratio:auto;height:80vh}a{color:LinkText}img{width:100%}" +
  ".live{margin-top:1rem}.live frond-view{height:auto;aspect-ratio:16/9}.live frond-view[src]{height:36rem;aspect-ratio:auto}" +
  ".live iframe{width:100%;border:1px solid GrayText;border-radius:0.5rem}.live canvas{max-width:100%}summary{padding:0.5rem 0}" +
  // With large words what is wider than a phone breaks, or scrolls by itself.
  "body{overflow-wrap:anywhere}:is(p,li,dd):has(math){overflow:auto hidden}" +
  "math{font-size:1.1em}.display{display:block;margin:0.5rem 0;overflow:auto hidden;text-align:center}" +
  "input{vertical-align:middle}h2{margin:2.5rem 0 0.25rem;font-size:1.125rem}p{margin:0.25rem 0 0.75rem}" +
  "pre{overflow:auto;padding:0.75rem 1rem;border:1px solid GrayText;border-radius:0.5rem;font-size:0.875rem}";

/** The page of a shape or a figure: read without a program, and with the real thing where there may be one. */
function viewPage(described: Described, site: string, view: string, fragment: string): string {
  const { title, picture } = described;
  const label = escaped(title);
  return page(
    described,
    site,
    `<frond-view ${view} poster="../${picture}" label="${label}" theme="auto" studio="../"></frond-view>
      <noscript><img src="../${picture}" alt="${label}" /></noscript>
      <p><a href="../index.html#${escaped(fragment)}">Open it in ${NAME}</a></p>`,
  );
}

/** What a page has besides its content: the element, unless it is said otherwise. */
interface Has {
  script: string;
  style: string;
}
const ELEMENT: Has = { script: "frond-view.js", style: "" };

function page(described: Described, site: string, content: string, has = ELEMENT): string {
  const { title, about, path } = described;
  const up = "../".repeat(path.split("/").length - 1) || "./";
  const html = `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <title>${escaped(title)} · ${NAME}</title>
    <meta name="description" content="${escaped(about)}" />
    <link rel="icon" href="${up}icon-192.png" />
    ${tags(described, site)}
    <style>${STYLE}${has.style}</style>
    <script type="module" src="${up}${has.script}"></script>
  </head>
  <body>
    <main>
      <h1>${escaped(title)}</h1>
      <p>${escaped(about)}</p>
      ${content}
    </main>
  </body>
</html>
`;
  // The element works in a worker of its own making, and shows figures in a frame.
  const policy = policyOf(html, { "frame-src": ["'self'"] });
  return html.replace(
    '<meta charset="utf-8" />',
    `<meta charset="utf-8" />\n    <meta http-equiv="Content-Security-Policy" content="${policy}" />`,
  );
}

/** All of them. */
export function sitePages(site: string, drawing: Drawer): SiteFile[] {
  const { between, picture, shape: named, shapes } = drawing;
  const gallery = shapes();
  const figures = figurePictures(drawing);
  const drawn = (maps: number[][]) => [{ maps: maps as MapRow[] }];
  const files: SiteFile[] = [
    {
      fileName: "frond.png",
      source: picture(drawn(between(named("fern"), named("maple"), 0.06)), UNFOLDED, 0.07),
    },
    ...ICONS.map(({ name, side, free }) => ({
      fileName: name,
      source: picture(drawn(named("maple").maps), { width: side, height: side }, free),
    })),
    { fileName: "manifest.webmanifest", source: manifest() },
    { fileName: "404.html", source: missingPage(site) },
  ];
  const described: Described[] = [];
  for (const { id, name, about, maps } of gallery) {
    const shape = { path: `shape/${id}.html`, title: name, about, picture: `shape/${id}.png` };
    files.push({ fileName: shape.picture, source: picture(drawn(maps), UNFOLDED, 0.07) });
    files.push({ fileName: shape.path, source: viewPage(shape, site, `a="${id}"`, `a=${id}&b=${id}`) });
    described.push(shape);
  }
  for (const { id, number, title, about } of listedFigures()) {
    const figure = {
      path: `figure/${id}.html`,
      title: `${number}: ${title}`,
      about,
      picture: `figure/${id}.png`,
      size: FIGURE,
    };
    const shown = figures[id];
    if (!shown) throw new Error(`figure-pictures.ts does not say what is in the picture of ${id}`);
    files.push({ fileName: figure.picture, source: picture(shown.cells, FIGURE, 0.07, shown.columns) });
    const fragment = `${number.startsWith("Lesson") ? "learn" : "figures"}/${id}`;
    files.push({ fileName: figure.path, source: viewPage(figure, site, `src="#${fragment}"`, fragment) });
    described.push(figure);
  }
  const elsewhere = {
    path: "elsewhere.html",
    title: "Use it elsewhere",
    about: "Frond on pages, in blogs, slides, notebooks and programs: each way with the lines that it takes.",
    picture: "frond.png",
  };
  const all = '<p><a href="./api/index.html">All functions of the package, with samples</a></p>';
  const out = '<p><a href="./index.html">Open the studio</a></p>';
  files.push({
    fileName: elsewhere.path,
    source: page(elsewhere, site, `${ways(site)}\n      ${all}\n      ${out}`),
  });
  described.push(elsewhere);
  const proofs = {
    path: "theorems.html",
    title: "What the proofs rest on",
    about: "Why an attractor that Frond calls in one piece is: the theorems, each with its proof.",
    picture: "frond.png",
  };
  files.push({ fileName: proofs.path, source: page(proofs, site, `${theorems()}\n      ${out}`) });
  described.push(proofs);
  for (const { content, ...rest } of apiPages()) {
    const functions = { ...rest, picture: "frond.png" };
    const studio = `<p><a href="../elsewhere.html">Use it elsewhere</a> · <a href="../index.html">Open the studio</a></p>`;
    const source = page(functions, site, `${content}\n      ${studio}`, {
      script: "api/api.js",
      style: API_STYLE,
    });
    files.push({ fileName: rest.path, source });
    described.push(functions);
  }
  if (site !== "") {
    const urls = ["", ...described.map(({ path }) => path)].map(
      (path) => `<url><loc>${escaped(site + path)}</loc></url>`,
    );
    const source = `<?xml version="1.0" encoding="UTF-8"?>\n<urlset xmlns="http://www.sitemaps.org/schemas/sitemap/0.9">\n${urls.join("\n")}\n</urlset>\n`;
    files.push({ fileName: "sitemap.xml", source });
  }
  return files;
}

function manifest(): string {
  const png = (src: string, side: number, purpose: string) => ({
    src,
    sizes: `${side}x${side}`,
    type: "image/png",
    purpose,
  });
  return JSON.stringify({
    name: NAME,
    short_name: NAME,
    description: ABOUT,
    start_url: "./",
    scope: "./",
    display: "standalone",
    file_handlers: [
      {
        action: "./",
        accept: {
          "text/plain": [".ifs", ".aifs"],
          "application/xml": [".flame"],
          "application/json": [".json"],
          "image/png": [".png"],
        },
      },
    ],
    icons: [
      png("icon-192.png", 192, "any"),
      png("icon-512.png", 512, "any"),
      png("icon-maskable.png", 512, "maskable"),
    ],
  });
}

/** FROND_SITE as it is used: with a slash at its end, or empty. */
export function siteOf(text: string | undefined): string {
  if (!text) return "";
  const address = folderAddress(text);
  if (address === null)
    throw new Error(
      `FROND_SITE is the address that the site will have, such as https://example.org/frond/, and not ${text}`,
    );
  return address;
}

const site = () => siteOf(process.env["FROND_SITE"]);

/** Adds them to the site while it is built. */
export const pages = {
  name: "site-pages",
  apply: "build" as const,
  async generateBundle(this: { emitFile(file: SiteFile & { type: "asset" }): void }) {
    for (const file of sitePages(site(), await drawer())) this.emitFile({ type: "asset", ...file });
  },
  transformIndexHtml: {
    order: "post" as const,
    handler: (html: string, { path }: { path: string }) =>
      path.endsWith("index.html")
        ? html.replace(
            "</title>",
            `</title>\n    ${tags({ path: "", title: NAME, about: ABOUT, picture: "frond.png" }, site())}`,
          )
        : html,
  },
};

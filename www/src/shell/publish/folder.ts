/** The texts of a published folder. Whatever a document brings stands in them as text. */
import { themeIn } from "#document/preferences";
import { escaped } from "#format/html";
import * as messages from "./messages";

/** Of pictures that unfold, as most messengers want them. */
export const UNFOLDED = { width: 1200, height: 630 };

/** What it does when it is opened, but for those who asked their system for less motion. */
export type Moves = "once" | "on" | "still";

/** The same as attributes of the element. */
export const AUTOPLAY: Record<Moves, string> = { once: " autoplay", on: " autoplay loop", still: "" };

export interface FilmFile {
  name: "film.gif" | "film.mp4";
  width: number;
  height: number;
}

export interface Publication {
  title: string;
  about: string;
  /** The whole link of the document; the studio is in the folder before its #. */
  address: string;
  /** Where the folder will be, with a slash at its end; null where nobody knows yet. */
  home: string | null;
  moves: Moves;
  film: FilmFile | null;
}

const STYLE =
  "body{max-width:60rem;margin:0 auto;padding:1.5rem;background:Canvas;color:CanvasText;font:1rem/1.5 system-ui,sans-serif}" +
  "frond-view{width:100%;aspect-ratio:16/9}img{width:100%;height:auto}h1{margin:0;overflow-wrap:anywhere}p{overflow-wrap:anywhere}";

/** The folder of the studio that a link opens. */
export const studioOf = (address: string): string => new URL("./", address).href.replace(/[?#].*$/, "");

function unfolding({ title, about, home, film }: Publication): string[] {
  const property = (name: string, content: string) =>
    `<meta property="og:${name}" content="${escaped(content)}" />`;
  const known = ["type", "title", "description"].map((name, i) =>
    property(name, ["website", title, about][i] ?? ""),
  );
  // Messengers follow whole addresses only.
  if (home === null) return known;
  return [
    `<link rel="canonical" href="${escaped(home)}" />`,
    ...known,
    property("url", home),
    property("image", `${home}picture.png`),
    property("image:width", String(UNFOLDED.width)),
    property("image:height", String(UNFOLDED.height)),
    '<meta name="twitter:card" content="summary_large_image" />',
    ...(film?.name === "film.mp4"
      ? [
          property("video", `${home}film.mp4`),
          property("video:type", "video/mp4"),
          property("video:width", String(film.width)),
          property("video:height", String(film.height)),
        ]
      : []),
  ];
}

/** Whether the picture is light or dark whatever the page of its readers is. */
export const themeOf = (address: string) => themeIn(new URL(address).search);

/** The page of the folder: read without a program, and with the real thing where there may be one. */
export function indexPage(publication: Publication): string {
  const { title, about, address, moves, film } = publication;
  const label = escaped(title);
  const picture = film?.name === "film.gif" ? film.name : "picture.png";
  return `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="${themeOf(address) ?? "light dark"}" />
    <title>${label}</title>
    <meta name="description" content="${escaped(about)}" />
    <link rel="icon" href="data:," />
    ${unfolding(publication).join("\n    ")}
    <style>${STYLE}</style>
    <script src="frond-view.js"></script>
  </head>
  <body>
    <main>
      <h1>${label}</h1>
      <p>${escaped(about)}</p>
      <frond-view src="${escaped(address)}" studio="${escaped(studioOf(address))}" poster="picture.png" label="${label}" theme="${themeOf(address) ?? "auto"}" controls${AUTOPLAY[moves]}></frond-view>
      <noscript><img src="${picture}" alt="${label}" /></noscript>
      <p><a href="${escaped(address)}">Open in Frond</a>${film ? ` · <a href="${film.name}">The film</a>` : ""}</p>
    </main>
  </body>
</html>
`;
}

/** What to do with the folder, in three lines. */
export function readme({ home, film }: Publication): string {
  const files = messages.folderFiles(film ? `${film.name}, ` : "");
  return [
    messages.uploadThisFolderTo(files),
    messages.toSeeWithoutHost,
    home === null ? messages.messengersShowPreviewOnly : messages.madeFor(home),
    "",
  ].join("\n");
}

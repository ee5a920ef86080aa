/**
 * "Use it elsewhere": how Frond comes into pages, blogs, slides and programs. Each way is one text, which is shown, and
 * which runs: as markup of the page, or as a program that `config.ts` builds of it.
 */
import { escaped } from "../../src/format/html.ts";

/** `$SITE` stands for the address of the site. */
interface Way {
  title: string;
  about: string;
  code: string;
  /** What runs, as markup; made of the code with the addresses of this page. */
  live(code: string): string;
}

/** Where a program finds its place, and the script that is built of its text. */
const program = (name: string, inside = "") =>
  `<div id="${name}">${inside}</div><script type="module" src="./elsewhere/${name}.js"></script>`;

const frame = (address: string, title: string) =>
  `<iframe src="${address}" title="${title}" width="640" height="400" loading="lazy"></iframe>`;

const WAYS = {
  shape: {
    title: "A shape on a page",
    about:
      "One script, then an element for each shape. It loads when it is near the screen, and needs no studio.",
    code: `<script src="$SITE/frond-view.js"></script>
<frond-view a="fern"></frond-view>`,
    // The page has the script already.
    live: (code) => code.replace(/<script.*<\/script>/, ""),
  },
  morph: {
    title: "A morph with a slider, that says whether it holds together",
    about: "Any two shapes, or maps of your own. Space plays it; arrow keys move it.",
    code: `<frond-view a="dragon-3" b="gasket" path="-0.125,1.156;0.5,1.766;0.938,1.578" t="0.4"
  controls loop verdict></frond-view>`,
    live: (code) => code,
  },
  lesson: {
    title: "A lesson, a figure or another tool",
    about:
      "What only the studio shows comes in a frame of it: a link of a lesson, of the bend, of space, or of a morph with its map.",
    code: `<frond-view src="$SITE/#learn/e1" label="The first lesson"></frond-view>`,
    live: (code) => code,
  },
  frame: {
    title: "Where no script is allowed: a frame",
    about:
      "Moodle, WordPress, Notion and others take this. Share, then Copy embed code, writes it for what you see.",
    code: `<iframe src="$SITE/embed.html?verdict#a=fern&amp;b=tree" title="A fern becomes a tree"
  width="640" height="400" loading="lazy"></iframe>`,
    live: (code) => code,
  },
  slides: {
    title: "In slides",
    about: "reveal.js loads the frame when its slide comes, and plays it as a background.",
    code: `<section data-background-iframe="$SITE/embed.html?controls=none&amp;play#a=levy&amp;b=dragon"></section>
<section><iframe data-src="$SITE/embed.html#a=fern&amp;b=tree" width="900" height="500"></iframe></section>`,
    live(code) {
      const [background = "", slide = ""] = [...code.matchAll(/(?:iframe|data-src)="([^"]*)"/g)].map(
        ([, address]) => address,
      );
      return `${frame(slide, "A slide: a fern becomes a tree")}
      <details><summary>The background, playing</summary>${frame(background, "A background: the Lévy curve becomes a dragon")}</details>`;
    },
  },
  jupyter: {
    title: "In a Jupyter notebook",
    about: "The dialog “Maps as text” also gives each shape as a Python program.",
    code: `from IPython.display import IFrame
IFrame("$SITE/embed.html#a=fern&b=tree", width=640, height=400)`,
    live: (code) => frame(escaped(/IFrame\("([^"]*)"/.exec(code)?.[1] ?? ""), "What the notebook shows"),
  },
  react: {
    title: "In React",
    about: "An element is an element; its events come by a reference. Here Preact runs the same text.",
    code: `import "frond-ifs/view";
import { useEffect, useRef } from "react";

export function Morph({ t, onVerdict }) {
  const view = useRef(null);
  useEffect(() => {
    const element = view.current;
    const told = ({ detail }) => onVerdict(detail.words);
    element.addEventListener("verdict", told);
    return () => element.removeEventListener("verdict", told);
  }, [onVerdict]);
  return <frond-view ref={view} a="dragon-3" b="gasket" path="straight" t={t} verdict="" />;
}`,
    live: () => program("react"),
  },
  observable: {
    title: "In Observable",
    about: "Three cells: a slider, the morph, and what joins them.",
    code: `viewof t = Inputs.range([0, 1], { label: "t" })

view = {
  await require("$SITE/frond-view.js").catch(() => {});
  return html\`<frond-view a="koch" b="levy" path="straight"></frond-view>\`;
}

{
  view.t = t;
}`,
    live: () => program("observable"),
  },
  draw: {
    title: "Without an element: ten lines",
    about:
      "The package draws into any canvas, decides, plans paths, fits outlines; in the browser and in Node.",
    code: `import init, { presets, rasterize } from "frond-ifs/draw";

await init();
const fern = presets().find(({ id }) => id === "fern");
const pixels = rasterize(fern, { width: 600, height: 600 });
const canvas = document.querySelector("#draw canvas");
canvas.getContext("2d").putImageData(new ImageData(pixels, 600, 600), 0, 0);`,
    live: () => program("draw", '<canvas width="600" height="600" role="img" aria-label="A fern"></canvas>'),
  },
} satisfies Record<string, Way>;

/** The programs among them, by the names of their scripts. */
export const PROGRAMS = {
  react: WAYS.react.code,
  observable: WAYS.observable.code.replaceAll("$SITE", "."),
  draw: WAYS.draw.code,
} as const;

/** The middle of the page. `site` ends with a slash, or is empty. */
export function ways(site: string): string {
  const address = (site || "https://…/").replace(/\/$/, "");
  return Object.values<Way>(WAYS)
    .map(
      ({ title, about, code, live }) => `
      <h2>${title}</h2>
      <p>${about}</p>
      <pre tabindex="0"><code>${escaped(code.replaceAll("$SITE", address))}</code></pre>
      <div class="live">${live(code.replaceAll("$SITE", "."))}</div>`,
    )
    .join("\n");
}

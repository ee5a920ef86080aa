/** "Use it elsewhere": how Frond comes into pages, blogs, slides and programs, each way with what it makes. */

import { escaped } from "../src/format/html.ts";

/** `$SITE` stands for the address of the site. */
interface Way {
  title: string;
  about: string;
  code: string;
  /** What the code makes, as markup; most of it is the code itself. */
  live?: string;
}

const WAYS: readonly Way[] = [
  {
    title: "A shape on a page",
    about:
      "One script, then an element for each shape. It loads when it is near the screen, and needs no studio.",
    code: `<script src="$SITE/frond-view.js"></script>
<frond-view a="fern"></frond-view>`,
    live: '<frond-view a="fern" theme="auto" label="A fern"></frond-view>',
  },
  {
    title: "A morph with a slider, that says whether it holds together",
    about: "Any two shapes, or maps of your own. Space plays it; arrow keys move it.",
    code: `<frond-view a="dragon-3" b="gasket" path="-0.125,1.156;0.5,1.766;0.938,1.578" t="0.4"
  controls loop verdict></frond-view>`,
    live: '<frond-view a="dragon-3" b="gasket" path="-0.125,1.156;0.5,1.766;0.938,1.578" t="0.4" controls loop verdict theme="auto"></frond-view>',
  },
  {
    title: "A lesson, a figure or another tool",
    about:
      "What only the studio shows comes in a frame of it: a link of a lesson, of the bend, of space, or of a morph with its map.",
    code: `<frond-view src="$SITE/#figures/e1" style="aspect-ratio: 1"></frond-view>`,
    live: '<frond-view src="#figures/e1" theme="auto" label="The first lesson" class="tall"></frond-view>',
  },
  {
    title: "Where no script is allowed: a frame",
    about:
      "Moodle, WordPress, Notion and others take this. Share, then Copy embed code, writes it for what you see.",
    code: `<iframe src="$SITE/embed.html?verdict#a=fern&amp;b=tree" title="A fern becomes a tree"
  width="640" height="400" loading="lazy"></iframe>`,
  },
  {
    title: "In slides",
    about: "reveal.js loads the frame when its slide comes, and plays it as a background.",
    code: `<section data-background-iframe="$SITE/embed.html?controls=none&amp;play#a=levy&amp;b=dragon"></section>
<section><iframe data-src="$SITE/embed.html#a=fern&amp;b=tree" width="900" height="500"></iframe></section>`,
  },
  {
    title: "In a Jupyter notebook",
    about: "The dialog “Maps as text” also gives each shape as a Python program.",
    code: `from IPython.display import IFrame
IFrame("$SITE/embed.html#a=fern&b=tree", width=640, height=400)`,
  },
  {
    title: "In React",
    about: "An element is an element; its events come by a reference.",
    code: `import "frond/view";

function Morph({ t, onVerdict }) {
  const view = useRef(null);
  useEffect(() => {
    const told = ({ detail }) => onVerdict(detail.words);
    view.current.addEventListener("verdict", told);
    return () => view.current?.removeEventListener("verdict", told);
  }, [onVerdict]);
  return <frond-view ref={view} a="dragon-3" b="gasket" t={t} verdict="" />;
}`,
  },
  {
    title: "In Observable",
    about: "Two cells: the second follows the slider of the first.",
    code: `viewof t = Inputs.range([0, 1], { label: "t" })

{
  await require("$SITE/frond-view.js").catch(() => {});
  return html\`<frond-view a="koch" b="levy" path="straight" t=\${t}></frond-view>\`;
}`,
  },
  {
    title: "Without an element: ten lines",
    about:
      "The package draws into any canvas, decides, plans paths, fits outlines; in the browser and in Node.",
    code: `import init, { presets, rasterize } from "frond/draw";

await init();
const fern = presets().find(({ id }) => id === "fern");
const pixels = rasterize(fern, { width: 600, height: 600 });
canvas.getContext("2d").putImageData(new ImageData(pixels, 600, 600), 0, 0);`,
  },
];

/** The middle of the page. `site` ends with a slash, or is empty. */
export function ways(site: string): string {
  const address = (site || "https://…/").replace(/\/$/, "");
  return WAYS.map(
    ({ title, about, code, live }) => `
      <h2>${title}</h2>
      <p>${about}</p>
      ${live ?? ""}
      <pre tabindex="0"><code>${escaped(code.replaceAll("$SITE", address))}</code></pre>`,
  ).join("\n");
}

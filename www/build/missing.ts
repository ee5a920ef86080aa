/**
 * 404.html: what a host shows in place of a page that is not there, at whatever address, so that nothing is fetched by
 * a relative one. Where the site will be may not be known: the folders that it has tell where it begins.
 */
import { policyOf } from "./policy.ts";

/** The folders of the site: what stands before one of them in an address is the studio's. */
const FOLDERS = ["shape", "figure", "figures", "assets", "elsewhere", "api"];

const STYLE =
  "body{max-width:40rem;margin:0 auto;padding:3rem 1.5rem;background:Canvas;color:CanvasText;font:1rem/1.5 system-ui,sans-serif}" +
  "h1{font-size:1.5rem}a{color:LinkText}p{overflow-wrap:anywhere}";

/**
 * Where an address leads that a host does not know: to the studio, and to the document that stands in the address
 * where a mailer wrote the # of a link as %23. It is text in the page, so it needs nothing from outside of it.
 */
export function homeOf(path: string, query: string, folders: readonly string[]): string {
  const [before = "", ...link] = (path + query).split(/%23/i);
  if (link.length > 0) return `${before.replace(/(?:index\.html)?(?:\?.*)?$/, "")}#${link.join("%23")}`;
  const parts = path.split("/");
  const at = parts.findIndex((part) => folders.includes(part));
  return `${parts.slice(0, at < 0 ? -1 : at).join("/")}/`;
}

/** The page. `site` ends with a slash, or is empty. */
export function missingPage(site: string): string {
  // An address of this host alone: "//.." would be another's.
  const script = `${homeOf.toString()};document.querySelector("a").href=location.origin+homeOf(location.pathname,location.search,${JSON.stringify(FOLDERS)})`;
  const html = `<!doctype html>
<html lang="en">
  <head>
    <meta charset="utf-8" />
    <meta name="viewport" content="width=device-width, initial-scale=1" />
    <meta name="color-scheme" content="light dark" />
    <meta name="robots" content="noindex" />
    <title>No such page · Frond</title>
    <style>${STYLE}</style>
  </head>
  <body>
    <main>
      <h1>There is no page at this address</h1>
      <p>It may have lost its end, or the page was moved. A link to a morph needs what stands behind its #.</p>
      <p><a href="${site || "./"}">Open the studio</a></p>
    </main>
    <script>${script}</script>
  </body>
</html>
`;
  return html.replace(
    '<meta charset="utf-8" />',
    `<meta charset="utf-8" />\n    <meta http-equiv="Content-Security-Policy" content="${policyOf(html)}" />`,
  );
}

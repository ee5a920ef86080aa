/** Text on its way into a page: nothing of it is ever read as markup. */

/** For text between tags and for quoted attributes. */
export const escaped = (text: string): string =>
  text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

/** The address of a folder as one types it, with a slash at its end; null where it is none of the web. */
export function folderAddress(text: string): string | null {
  const url = URL.canParse(text) ? new URL(text) : null;
  if (!url || !/^https?:$/.test(url.protocol)) return null;
  url.search = "";
  url.hash = "";
  return url.href.replace(/\/index\.html$/, "/").replace(/[^/]*$/, (rest) => (rest === "" ? "" : `${rest}/`));
}

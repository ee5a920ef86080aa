/** Text on its way into a page: nothing of it is ever read as markup. */

/** For text between tags and for quoted attributes. */
export const escaped = (text: string): string =>
  text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;").replace(/"/g, "&quot;");

/** The address of a folder as one types it, with a slash at its end; null where it is none of the web. */
export function folderAddress(text: string): string | null {
  // The parser would make an address of "http:/name" as well.
  if (!/^https?:\/\/[^/]/i.test(text) || !URL.canParse(text)) return null;
  const url = new URL(text);
  url.search = "";
  url.hash = "";
  return url.href.replace(/\/index\.html$/, "/").replace(/[^/]*$/, (rest) => (rest === "" ? "" : `${rest}/`));
}

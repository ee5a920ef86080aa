/** What the service worker keeps of the site, and what it lets go again. */

/** All that is kept, at most. */
export const MOST_BYTES = 15_000_000;

/**
 * How a request is answered. What has a hash in its name never changes: the copy will do. All else is asked for first,
 * and the copy serves who is off line: so old and new files are never mixed. Null: it is none of the worker's business.
 */
export function wayOf(request: { method: string; url: string }, scope: string): "copy" | "fresh" | null {
  if (request.method !== "GET" || !request.url.startsWith(scope)) return null;
  return request.url.startsWith(`${scope}assets/`) ? "copy" : "fresh";
}

/** Under what a file is kept: options of a page are read by the page itself. */
export function nameOf(url: string): string {
  const plain = new URL(url);
  plain.search = "";
  plain.hash = "";
  return plain.href;
}

export interface Kept {
  url: string;
  bytes: number;
}

/** What has to go so that at most so many bytes stay: the oldest first, what pages use now last of all. */
export function surplus(kept: readonly Kept[], used: ReadonlySet<string>, most = MOST_BYTES): string[] {
  let bytes = kept.reduce((sum, file) => sum + file.bytes, 0);
  const inOrder = [...kept.filter(({ url }) => !used.has(url)), ...kept.filter(({ url }) => used.has(url))];
  const gone: string[] = [];
  for (const file of inOrder) {
    if (bytes <= most) break;
    bytes -= file.bytes;
    gone.push(file.url);
  }
  return gone;
}

/** What the built pages let in: a Content-Security-Policy in each, as narrow as the page can live with. */
import { createHash } from "node:crypto";

/** By directive; `script-src` and `style-src` get the hashes of what stands in the page itself. */
const POLICY: Readonly<Record<string, readonly string[]>> = {
  "default-src": ["'none'"],
  // Modules are compiled; no text is ever run.
  "script-src": ["'self'", "'wasm-unsafe-eval'"],
  // In a sandboxed frame a worker starts from a text that imports it (`www/src/workers/sandboxed.ts`).
  "worker-src": ["'self'", "blob:"],
  "style-src": ["'self'"],
  // Pictures that users choose, and those that the page makes.
  "img-src": ["'self'", "data:", "blob:"],
  "media-src": ["blob:"],
  "connect-src": ["'self'"],
  "manifest-src": ["'self'"],
  "base-uri": ["'none'"],
  "form-action": ["'none'"],
};

/** The policy of a page, with what this one lets in besides. */
export function policyOf(html: string, besides: Readonly<Record<string, readonly string[]>> = {}): string {
  const inline: Record<string, string[]> = {
    "script-src": [...html.matchAll(/<script>(.*?)<\/script>/gs)].map(([, text = ""]) => hashOf(text)),
    "style-src": [...html.matchAll(/<style>(.*?)<\/style>/gs)].map(([, text = ""]) => hashOf(text)),
  };
  const policy = {
    ...POLICY,
    ...Object.fromEntries(Object.keys(besides).map((key) => [key, POLICY[key] ?? []])),
  };
  return Object.entries(policy)
    .map(([directive, sources]) =>
      [directive, ...sources, ...(besides[directive] ?? []), ...(inline[directive] ?? [])].join(" "),
    )
    .join("; ");
}

const hashOf = (text: string) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;

/** Writes it into each page that is built, before anything that it is about. */
export const securityPolicy = {
  name: "security-policy",
  apply: "build" as const,
  transformIndexHtml: {
    order: "post" as const,
    handler: (html: string) =>
      html.replace(
        '<meta charset="utf-8" />',
        `<meta charset="utf-8" />\n    <meta http-equiv="Content-Security-Policy" content="${policyOf(html)}" />`,
      ),
  },
};

/** The Content-Security-Policy of the built pages stays narrow. */
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";
import { policyOf, securityPolicy } from "../../www/build/policy";

const page = (name: string) => readFileSync(fileURLToPath(new URL(`../../${name}`, import.meta.url)), "utf8");

it.each(["index.html", "embed.html"])("%s lets nothing in from elsewhere, and runs no text", (name) => {
  const html = page(name);
  const policy = policyOf(html);
  const sources = policy.split("; ").flatMap((directive) => directive.split(" ").slice(1));
  for (const source of sources) {
    expect(source).toMatch(/^('none'|'self'|'wasm-unsafe-eval'|'sha256-[\w+/]{43}='|data:|blob:)$/);
  }
  expect(policy.startsWith("default-src 'none'; ")).toBe(true);
  // Pictures alone may be written in an address. The page makes those itself, and workers where a sandbox allows none
  // by address.
  for (const directive of policy.split("; ")) {
    if (directive.includes(" data:")) expect(directive).toMatch(/^img-src /);
    if (directive.includes(" blob:")) expect(directive).toMatch(/^(img|media|worker)-src /);
  }
  // What stands in the page is let in by what it says, to the letter.
  for (const [, text = ""] of html.matchAll(/<(?:script|style)>(.*?)<\/(?:script|style)>/gs)) {
    expect(policy).toContain(createHash("sha256").update(text).digest("base64"));
  }
  const written = securityPolicy.transformIndexHtml.handler(html);
  expect(written.indexOf("Content-Security-Policy")).toBeLessThan(written.indexOf("<script"));
  expect(written.indexOf("Content-Security-Policy")).toBeGreaterThan(0);
});

import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { theorems } from "../../www/build/theorems";

/** The kinds of reasons, as the programming interface has them. */
function kinds(): string[] {
  const api = readFileSync(new URL("../../crate/web/src/api.d.ts", import.meta.url), "utf8");
  const [, union = ""] = /export type ReasonKind =([^;]*);/.exec(api) ?? [];
  return [...union.matchAll(/"([^"]+)"/g)].map(([, kind = ""]) => kind);
}

it("has one place for every kind of reason", () => {
  const text = theorems();
  expect(kinds().length).toBeGreaterThan(5);
  for (const kind of kinds()) expect(text.split(`id="${kind}"`), kind).toHaveLength(2);
});

it("has the theorems on joints and on what lies apart, to which the path and the verdict lead", () => {
  for (const kind of ["joints", "apart"]) expect(theorems().split(`id="${kind}"`), kind).toHaveLength(2);
});

it("closes what it opens", () => {
  const open: string[] = [];
  for (const [, slash, name = ""] of theorems().matchAll(/<(\/?)([a-z0-9]+)[^>]*>/g)) {
    if (slash) expect(open.pop()).toBe(name);
    else open.push(name);
  }
  expect(open).toEqual([]);
});

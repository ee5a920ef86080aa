import { expect, it } from "vitest";
import { nameOf, surplus, wayOf } from "./keep";

const SCOPE = "https://example.org/frond/";

it("answers for the site alone, and takes copies only of what never changes", () => {
  const way = (path: string, method = "GET") => wayOf({ method, url: new URL(path, SCOPE).href }, SCOPE);
  expect(way("assets/first-abc.js")).toBe("copy");
  for (const path of ["", "index.html?play", "frond-view.js", "shape/fern.html"])
    expect(way(path)).toBe("fresh");
  for (const path of ["../other/", "https://elsewhere.org/frond/assets/a.js", "https://example.org/frondly/"])
    expect(way(path)).toBeNull();
  expect(way("", "POST")).toBeNull();
  expect(nameOf(`${SCOPE}embed.html?verdict#a=fern`)).toBe(`${SCOPE}embed.html`);
});

it("lets the oldest go, and what is used last of all", () => {
  const kept = ["a", "b", "c", "d"].map((url) => ({ url, bytes: 10 }));
  expect(surplus(kept, new Set(), 40)).toEqual([]);
  expect(surplus(kept, new Set(), 25)).toEqual(["a", "b"]);
  expect(surplus(kept, new Set(["a", "b"]), 25)).toEqual(["c", "d"]);
  expect(surplus(kept, new Set(["a", "b"]), 5)).toEqual(["c", "d", "a", "b"]);
  expect(surplus([], new Set(), 0)).toEqual([]);
});

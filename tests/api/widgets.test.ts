import { readdirSync, readFileSync } from "node:fs";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";

const ui = fileURLToPath(new URL("../../www/src/ui", import.meta.url));
/** Seen within others, or no widget. */
const ELSEWHERE = ["Icon", "problems", "lazy"];

it("shows every widget on the page of widgets", () => {
  const components = readdirSync(ui, { recursive: true, encoding: "utf8" }).filter((path) =>
    path.endsWith(".tsx"),
  );
  const page = components
    .filter((path) => path.startsWith("widgets"))
    .map((path) => readFileSync(join(ui, path), "utf8"))
    .join("");
  const missing = components
    .filter((path) => !path.startsWith("widgets"))
    .map((path) => basename(path, ".tsx"))
    .filter((name) => !ELSEWHERE.includes(name) && !page.includes(`/${name}"`));
  expect(missing).toEqual([]);
});

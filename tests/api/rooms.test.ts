/** A room of the page is left by `#room/file` only, which the linter looks at; a tool has nothing of another one. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { expect, it } from "vitest";

const root = fileURLToPath(new URL("../../www/src", import.meta.url));
const files = readdirSync(root, { recursive: true, encoding: "utf8" }).filter((path) => /\.tsx?$/.test(path));

/** The room of a file, and which tool where it is of one. */
const roomOf = (path: string) => path.split("/", path.startsWith("tools/") ? 2 : 1).join("/");

it("is left by no relative import", () => {
  const leaving = files.flatMap((path) =>
    [...readFileSync(join(root, path), "utf8").matchAll(/(?:from|import)[ (]"(\.[^"]+)"/g)]
      .map(([, to = ""]) => to)
      // What is no part of the page's sources is in no room.
      .filter((to) => !join(path, "..", to).startsWith(".."))
      .filter((to) => path.includes("/") && roomOf(join(path, "..", to)) !== roomOf(path))
      .map((to) => `${path}: ${to}`),
  );
  expect(leaving).toEqual([]);
});

import { expect, test } from "vitest";
import { palette } from "#style/palette";
import type { Scene } from "#wasm/api";
import { ownColours, pieceColours, withoutColours } from "./colours";
import { scene, start } from "./scene";

const plain = scene.peek();
const coloured: Scene = { ...plain, palette: ["#ff0000", "#00ff00"] };

test("pieces have the colours of the document where it has some, else those of the page", () => {
  expect(pieceColours("dark")).toEqual(palette("dark"));
  start(coloured);
  expect(pieceColours("dark")).toEqual(["#ff0000", "#00ff00"]);
  expect(pieceColours("light")).toEqual(["#ff0000", "#00ff00"]);
  start(withoutColours(coloured));
  expect(pieceColours("light")).toEqual(palette("light"));
  expect("palette" in scene.peek()).toBe(false);
});

test("closed curves, and lists of no colours, have those of the page", () => {
  expect(ownColours({ ...coloured, palette: [] })).toBeNull();
  expect(ownColours({ ...coloured, curves: {} as NonNullable<Scene["curves"]> })).toBeNull();
});

import { expect, it } from "vitest";
import { scene } from "#document/scene";
import type { MapRow, Scene, Shape } from "#wasm/api";
import { changedWord, noteMatched } from "./matched";

const half: MapRow = [0.5, 0, 0, 0.5, 0, 0];
const shape = (preset?: string): Shape => ({
  name: "One",
  maps: [half, half],
  ...(preset ? { preset } : {}),
});
const now = (more: Partial<Scene> = {}): Scene => ({ ...scene.peek(), a: shape(), b: shape(), ...more });

it("does not call edited what a way across has matched", () => {
  const matched = noteMatched(shape("koch"), shape());
  const again = noteMatched(matched, shape());
  expect([matched, again].map((one) => changedWord(one, now()))).toEqual(["matched", "matched"]);
  const edited = shape();
  expect(changedWord(edited, now())).toBe("edited");
  expect(changedWord(noteMatched(edited, shape()), now())).toBe("edited");
});

it("says nothing of what came by a link and may have been matched joint by joint", () => {
  const joined: Partial<Scene> = { mode: "linear", path: { kind: "straight", points: [] } };
  expect(changedWord(shape(), now(joined))).toBeNull();
  expect(changedWord(shape(), now({ ...joined, b: shape("koch") }))).toBe("edited");
  expect(changedWord(shape(), now({ ...joined, mode: "polar" }))).toBe("edited");
});

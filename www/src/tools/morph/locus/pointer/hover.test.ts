import { afterAll, beforeEach, expect, it } from "vitest";
import { setView } from "../view/view";
import { followPointer, pointed } from "./hover";

const stop = followPointer();
afterAll(stop);

beforeEach(() => setView({ x: 0.5, y: 0.5, zoom: 1 }));

it("lets go of what a mouse points at when the map moves away below it", () => {
  pointed.value = { at: [0.3, 0.6], by: "mouse" };
  setView({ w: 0 });
  expect(pointed.value).not.toBeNull();
  setView({ zoom: 1e6 });
  expect(pointed.value).toBeNull();
});

it("keeps the cross of the keys, which stands on the map and not on the glass", () => {
  pointed.value = { at: [0.3, 0.6], by: "keys" };
  setView({ zoom: 8 });
  expect(pointed.value?.at).toEqual([0.3, 0.6]);
});

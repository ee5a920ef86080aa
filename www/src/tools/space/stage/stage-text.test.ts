import { expect, test } from "vitest";
import { countsWords, handWords, insideWords, statusWords, troubleOf } from "./stage-text";

test("it says how much of the picture is there, and calls it complete only when it is", () => {
  expect(statusWords({ backend: null, complete: false, settled: false, points: 0 })).toBe("Preparing …");
  expect(statusWords({ backend: "webgl2", complete: false, settled: false, points: 1_000_000 })).toBe(
    "1.0 M points, completing …",
  );
  expect(statusWords({ backend: "webgl2", complete: true, settled: true, points: 0 })).toBe(
    "Complete picture",
  );
  expect(statusWords({ backend: "webgl2", complete: true, settled: false, points: 0 })).toMatch(/smoothing/);
  expect(statusWords({ backend: "canvas", complete: false, settled: false, points: 0 })).toBe(
    "Coarse picture",
  );
});

test("it counts", () => {
  expect(countsWords(1, 4)).toBe("4 maps");
  expect(countsWords(1, 1)).toBe("1 map");
  expect(countsWords(3, 12)).toBe("3 objects, 12 maps");
});

test("what is behind is known at once, what is beside when the picture is complete", () => {
  expect(troubleOf("behind", { complete: false, empty: false })).toBe("behind");
  expect(troubleOf("before", { complete: false, empty: true })).toBeNull();
  expect(troubleOf("before", { complete: true, empty: true })).toBe("nothing");
  expect(troubleOf("around", { complete: true, empty: false })).toBeNull();
});

test("it names what the eye is inside of", () => {
  expect(insideWords([])).toBeNull();
  expect(insideWords(["Dragon"])).toBe("The eye is inside Dragon.");
  expect(insideWords(["Dragon", "Fern"])).toBe("The eye is inside 2 objects.");
});

test("it says what a drag is about where there are several", () => {
  const objects = [{ name: "Ground" }, { name: "Oak" }];
  expect(handWords("turn", objects, 1)).toBe("Turns Oak");
  expect(handWords("look", objects, 1)).toBeNull();
  expect(handWords("scale", objects.slice(0, 1), 0)).toBeNull();
});

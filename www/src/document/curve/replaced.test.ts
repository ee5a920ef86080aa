import { afterEach, beforeEach, expect, test } from "vitest";
import type { CurveShape } from "#wasm/api";
import { dismiss, notices } from "../notice";
import { edit, scene, start } from "../scene";
import { withCurve, withoutCurves } from "./changes";
import { tellReplaced } from "./replaced";

const BLANK = scene.peek();
const shape = (name: string): CurveShape => ({ name, curve: { knots: [], edges: [] } });
const [mine, oak] = [shape("My leaf"), shape("Oak")];

beforeEach(() => start(BLANK));
afterEach(() => {
  for (const { id } of notices.peek()) dismiss(id);
});

test("the end that was not chosen is named where it had to give way, and comes back", () => {
  edit((before) => withCurve(before, "b", mine, oak));
  expect(tellReplaced(BLANK, "b")).toBe(true);
  const [notice] = notices.peek();
  expect(notice?.text).toBe("Outlines morph only into outlines, so A is now Oak instead of Gasket.");
  notice?.action?.run();
  expect(scene.peek()).toEqual(BLANK);
});

test("a shape that gave way to an outline is offered edge by edge with it", () => {
  const long = shape("leaf_acer_saccharinum_864");
  edit((before) => withCurve(before, "b", long, oak));
  tellReplaced(BLANK, "b");
  expect(notices.peek()[0]?.instead?.label).toBe("Gasket to leaf_acer_sacchar…");
  start(BLANK);
  edit((before) => withCurve(before, "a", mine, oak));
  tellReplaced(BLANK, "a");
  expect(notices.peek()[1]?.instead?.label).toBe("My leaf to Mirrored gasket");
});

test("of what is bent it is said what was there, and no word of the other end", () => {
  edit((before) => withCurve(before, "a", mine, oak));
  tellReplaced(BLANK, "bent");
  const [notice] = notices.peek();
  expect([notice?.text, notice?.instead]).toEqual(["My leaf replaces Gasket.", undefined]);
});

test("so is an outline that gives way to a system", () => {
  start(withCurve(BLANK, "b", mine, oak));
  const before = scene.peek();
  edit(withoutCurves);
  expect(tellReplaced(before, "a")).toBe(true);
  expect(notices.peek()[0]?.text).toMatch(
    /^Outlines morph only .* B is now Mirrored gasket instead of My leaf\.$/,
  );
});

test("nothing is told where the other end stays", () => {
  start(withCurve(BLANK, "b", mine, oak));
  const before = scene.peek();
  edit((now) => withCurve(now, "b", oak, mine));
  expect(tellReplaced(before, "b")).toBe(false);
  expect(notices.peek()).toEqual([]);
});

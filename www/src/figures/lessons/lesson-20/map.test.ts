import { expect, it } from "vitest";
import { STATE } from "#geometry/states";
import { touched, unproved } from "./map";

it("keeps one mark in a cell, the latest, and not too many", () => {
  const one = touched([], { at: [0.51, 0.51], mark: "whole" });
  expect(touched(one, { at: [0.54, 0.52], mark: "broken" })).toEqual([{ at: [0.54, 0.52], mark: "broken" }]);
  expect(touched(one, { at: [0.56, 0.52], mark: "broken" })).toHaveLength(2);
  let many = one;
  for (let i = 0; i < 1000; i++) many = touched(many, { at: [i, 0], mark: "whole" });
  expect(many).toHaveLength(300);
  expect(many.at(-1)?.at).toEqual([999, 0]);
});

it("finds the samples that are not proved in the middle of their pixels", () => {
  const state = [STATE.connected, STATE.touching, STATE.disconnected, STATE.undecided];
  expect(unproved({ width: 2, height: 2, state, bounds: { u0: 0, v0: 0, u1: 2, v1: 2 } })).toEqual([
    [1.5, 0.5],
  ]);
});

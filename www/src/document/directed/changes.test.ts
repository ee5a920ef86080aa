import { describe, expect, it } from "vitest";
import type { DirectedShape, Scene } from "#wasm/api";
import { withoutCurves } from "../curve/changes";
import { scene as present } from "../scene";
import {
  directedAtBoth,
  oneState,
  sameDirected,
  setStates,
  swapDirected,
  systemOf,
  withDirected,
  withHalfTurns,
  withSystem,
} from "./changes";

const PLAIN = present.peek();
const shape = (name: string, x = 0): DirectedShape => ({
  preset: name,
  name,
  states: [[{ from: 1, map: [0.5, 0, 0, 0.5, x, 0] }], [{ from: 0, map: [0.5, 0, 0, 0.5, 0, x] }]],
});
const [flake, quilt] = [shape("flake"), shape("quilt", 1)];
const fern = { preset: "fern", name: "Fern", maps: PLAIN.b.maps.slice(0, 2) };

describe("graph-directed shapes in a document", () => {
  it("come one by one: the other end stays what it is, as a system of one state", () => {
    const seen: Scene = { ...PLAIN, view: { x: 0, y: 0, zoom: 3 } };
    const one = withDirected(seen, "b", flake);
    expect(one.directed).toEqual({ a: oneState(PLAIN.a), b: flake });
    expect([one.a, one.b, one.view]).toEqual([PLAIN.a, PLAIN.b, undefined]);
    const both = withDirected({ ...one, view: { x: 1, y: 1, zoom: 2 } }, "a", quilt);
    expect(both.directed).toEqual({ a: quilt, b: flake });
    expect(both.view).toEqual({ x: 1, y: 1, zoom: 2 });
  });

  it("take the place of closed curves, and are gone where systems are back", () => {
    const edge = { name: "Edge", curve: { knots: [], edges: [] } };
    const curves = { ...PLAIN, curves: { a: edge, b: edge } };
    const one = withDirected(curves, "a", flake);
    expect(one.curves).toBeUndefined();
    expect(one.directed?.b).toEqual(oneState(PLAIN.b));
    expect(withoutCurves(one)).toEqual(PLAIN);
  });

  it("give way to systems once both ends are one", () => {
    const both: Scene = { ...PLAIN, correspondence: [2, 0, 1], directed: { a: flake, b: quilt } };
    const one = withSystem(both, "a", fern);
    expect(one.directed).toEqual({ a: oneState(fern), b: quilt });
    const none = withSystem(one, "b", fern);
    expect(none.directed).toBeUndefined();
    expect([none.a.maps, none.b, none.correspondence]).toEqual([fern.maps, fern, []]);
    // The end that was never touched is the gallery's still.
    const back = withSystem(withDirected(PLAIN, "a", flake), "a", fern);
    expect([back.a, back.b]).toEqual([fern, PLAIN.b]);
    expect(withSystem(PLAIN, "a", fern)).toBe(PLAIN);
  });

  it("are swapped, copied and edited", () => {
    const both: Scene = { ...PLAIN, t: 0.25, directed: { a: flake, b: quilt } };
    expect(swapDirected(both)).toEqual({ ...both, t: 0.75, directed: { a: quilt, b: flake } });
    const turned = withHalfTurns(both, "clockwise");
    expect(turned.directed).toEqual({ a: flake, b: quilt, halfTurns: "clockwise" });
    expect(swapDirected(turned).directed).toEqual({ a: quilt, b: flake, halfTurns: "counterclockwise" });
    expect(withHalfTurns(turned, "signs")).toEqual(both);
    expect(setStates(turned, "a", quilt.states).directed?.halfTurns).toBe("clockwise");
    expect(withDirected(turned, "a", quilt).directed).toEqual({ a: quilt, b: quilt });
    expect(directedAtBoth(both, "b").directed).toEqual({ a: quilt, b: quilt });
    expect(setStates(both, "a", quilt.states).directed?.a).toEqual({ name: "flake", states: quilt.states });
    for (const change of [swapDirected, (now: Scene) => directedAtBoth(now, "a")])
      expect(change(PLAIN)).toBe(PLAIN);
    expect(sameDirected({ a: flake, b: quilt })).toBe(false);
    expect(sameDirected({ a: flake, b: { ...shape("flake"), name: "else" } })).toBe(true);
    expect(systemOf(oneState(fern))).toEqual({ name: "Fern", maps: fern.maps });
    expect(systemOf(flake)).toBeNull();
  });
});

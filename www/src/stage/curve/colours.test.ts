import { describe, expect, it } from "vitest";
import { edgeColours, mixed } from "./colours";

const PALETTE = ["#000000", "#111111", "#222222", "#333333"];
/**
 * Edges: straight; copies of an arc, of a longer one from the same knot, and of the first again at A; of one arc at B.
 */
const ARCS = [-1, 0, -1, 0, 5, 2, 2, 3, 5, 3, 2, 3, 5, 2, -1, 0];
const names = (s: number, colouring: "map" | "address" | "density") => {
  const found = edgeColours(ARCS, s, colouring, PALETTE);
  return found && [...found.kinds].map((kind) => found.colours[kind]);
};

describe("the colours of edges", () => {
  it("are those of the arcs that are copied, straight edges apart", () => {
    expect(names(0, "map")).toEqual(["#000000", "#111111", "#222222", "#111111"]);
    expect(names(1, "map")).toEqual(["#000000", "#111111", "#111111", "#000000"]);
  });
  it("go over from one end to the other", () => {
    expect(names(0.5, "map")).toEqual(["#000000", "#111111", "#1a1a1a", "#090909"]);
  });
  it("change from edge to edge, or not at all", () => {
    expect(names(0, "address")).toEqual(["#000000", "#222222", "#333333", "#111111"]);
    expect(names(0, "density")).toBeNull();
    expect(edgeColours([], 0, "map", PALETTE)).toEqual({ colours: [], kinds: new Uint16Array(0) });
    expect(edgeColours(ARCS, 0, "map", ["#000000"])).toBeNull();
  });
  it("are mixed in sixteen steps", () => {
    expect(mixed("#ff0000", "#0000ff", 0.5)).toBe("#800080");
    expect(mixed("#ff0000", "#0000ff", 0.51)).toBe("#800080");
    expect(mixed("#abcdef", "#abcdef", 0.3)).toBe("#abcdef");
  });
});

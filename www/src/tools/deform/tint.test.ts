import { describe, expect, it } from "vitest";
import { AT_REST } from "#document/deform/bend";
import { scene } from "#document/scene";
import {
  blended,
  cornersOf,
  FIRST,
  type Four,
  firstTint,
  isBlended,
  withColouring,
  withCorner,
} from "./tint";

const sides = { columns: 3, rows: 5 };
const four: Four = ["#000000", "#ff0000", "#00ff00", "#ffff00"];

describe("blended", () => {
  it("has its corners, and what lies between them", () => {
    const colours = blended(four, sides);
    expect(colours).toHaveLength(15);
    expect(cornersOf(colours, sides)).toEqual(four);
    expect(colours[1]).toBe("#800000");
    expect(colours[7]).toBe("#808000");
    expect(isBlended(colours, sides)).toBe(true);
  });
});

describe("withCorner", () => {
  it("blends anew as long as nothing else was chosen", () => {
    const after = withCorner(blended(four, sides), sides, 3, "#0000ff");
    expect(cornersOf(after, sides)[3]).toBe("#0000ff");
    expect(isBlended(after, sides)).toBe(true);
  });

  it("leaves what was chosen one by one", () => {
    const own = blended(four, sides).map((c, i) => (i === 7 ? "#123456" : c));
    expect(isBlended(own, sides)).toBe(false);
    const after = withCorner(own, sides, 0, "#0000ff");
    expect(after.map((c, i) => (c === own[i] ? null : i)).filter((i) => i !== null)).toEqual([0]);
  });
});

describe("withColouring", () => {
  it("gives the grid colours when they are first asked for, and keeps them after", () => {
    const bent = { ...scene.peek(), deform: AT_REST };
    const grid = withColouring(bent, "grid", AT_REST);
    expect(cornersOf(grid.deform?.tint?.colours ?? [], AT_REST)).toEqual(FIRST);
    const plain = withColouring(grid, "map", AT_REST);
    expect(plain.deform).toBe(grid.deform);
    expect(withColouring(plain, "grid", AT_REST).deform).toBe(grid.deform);
    expect(withColouring(grid, "grid", AT_REST)).toBe(grid);
  });

  it("never asks for more than the bend has", () => {
    const { kb, ke } = firstTint({ ...AT_REST, kb: 8, ke: 9 });
    expect(kb).toBeLessThanOrEqual(ke);
    expect(firstTint({ ...AT_REST, kb: 0, ke: 2 }).ke).toBe(2);
  });
});

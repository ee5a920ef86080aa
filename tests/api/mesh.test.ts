import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { bentAt } from "../../www/src/geometry/bezier";
import type { Mesh } from "../../www/src/geometry/mesh";

interface Meshes {
  /** Rows from below, columns from the left, dx and dy. */
  meshes: Record<string, { box: Mesh["box"]; D: number[][][] }>;
}
interface Displacements {
  cases: { mesh: string; x: [number, number]; v: [number, number] }[];
}

const folder = process.env["FROND_KNOWN"] ?? "tests/known";
const read = (name: string): unknown => JSON.parse(readFileSync(`${folder}/deform/${name}.json`, "utf8"));
const { meshes } = read("meshes") as Meshes;
const { cases } = read("mesh") as Displacements;

function known(name: string): Mesh {
  const mesh = meshes[name];
  if (!mesh) throw new Error(`no mesh ${name}`);
  return { columns: mesh.D[0]?.length ?? 0, rows: mesh.D.length, box: mesh.box, moves: mesh.D.flat(2) };
}

describe("the page's own blend of the mesh", () => {
  it("has cases to agree with", () => {
    expect(cases.length).toBeGreaterThan(10);
  });

  it.each(cases)(
    "agrees with the known displacement of $mesh at $x, outside the box too",
    ({ mesh: name, x, v }) => {
      const mesh = known(name);
      const [x0, y0, x1, y1] = mesh.box;
      const [px, py] = bentAt(mesh, (x[0] - x0) / (x1 - x0), (x[1] - y0) / (y1 - y0));
      expect(px - x[0]).toBeCloseTo(v[0], 11);
      expect(py - x[1]).toBeCloseTo(v[1], 11);
    },
  );
});

/** The small module, which draws a morph on other people's pages: what it draws is what the large one draws. */
import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import init, { LinkedMorph } from "../../www/pkg/frond-morph.js";
import * as frond from "../../www/pkg/index.js";
import { load, refused } from "./frond";

describe("the morph of a link", () => {
  beforeAll(async () => {
    const file = new URL("../../www/pkg/frond-morph_bg.wasm", import.meta.url);
    await Promise.all([load(), init({ module_or_path: readFile(file) })]);
  });

  it("has the maps, the boxes and the pixels that the studio has", () => {
    const link = "v=1&a=fern&b=gasket&path=drawn:0.2,0.7&t=0.25&turns=0,1,0,0";
    const morph = new LinkedMorph(`https://example.org/#${link}`);
    expect([morph.a, morph.b, morph.t, morph.mode]).toEqual(["Fern", "Gasket", 0.25, "polar"]);
    expect([...morph.path]).toEqual([0.2, 0.7, 0]);
    expect(morph.unplanned).toBe(false);
    const { scene } = frond.decodeScene(link);
    const { from, to } = frond.pair({ maps: scene.a.maps }, { maps: scene.b.maps });
    const options = { u: 0.2, v: 0.7, turns: [...morph.turns] };
    const ifs = frond.interpolate({ maps: from }, { maps: to }, options);
    expect([...morph.maps(0.2, 0.7, 0)]).toEqual(ifs.maps.flat());
    const { min, max } = frond.bounds(ifs);
    expect([...morph.bounds(0.2, 0.7, 0)]).toEqual([...min, ...max]);
    const view = { x: 0, y: 4, scale: 9 };
    const palette = ["#0072b2", "#e69f00"];
    const pixels = frond.rasterize(ifs, { width: 90, height: 80, view, palette });
    const drawn = morph.draw(0.2, 0.7, 0, 90, 80, 0, 4, 9, Uint32Array.of(0x0072b2, 0xe69f00));
    expect(drawn.some((byte) => byte > 0)).toBe(true);
    expect([...drawn]).toEqual([...pixels]);
    morph.free();
  });

  it("is refused with words where it cannot be", () => {
    expect(refused(() => new LinkedMorph("a=nobody"))).toBe("link-damaged");
    expect(refused(() => new LinkedMorph("a=maps:2,0,0,2,0,0"))).toMatch(/^link-/);
    const morph = new LinkedMorph("a=koch&b=koch");
    expect(morph.unplanned).toBe(true);
    expect(refused(() => morph.draw(0, 0, 0, 9000, 10, 0, 0, 1, new Uint32Array()))).toBe(
      "picture-too-large",
    );
    expect(refused(() => morph.draw(0, 0, 0, 10, 10, 0, Number.NaN, 1, new Uint32Array()))).toBe("view");
    expect(morph.maps(Number.NaN, 0, 0)).toHaveLength(24);
    morph.free();
    // Far from both shapes maps no longer shrink.
    const far = new LinkedMorph("a=koch&b=gasket&mode=linear");
    expect(refused(() => far.bounds(1e6, 0, 0))).toBe("no-attractor");
    far.free();
  });
});

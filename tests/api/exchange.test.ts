import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import init, * as exchange from "../../www/pkg/frond-exchange.js";
import { load, refused, shape, wrong } from "./frond";

const bytes = (text: string) => new TextEncoder().encode(text);

/** A PNG of one pixel. */
const DOT = Buffer.from(
  "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNkYPhfDwAChwGA60e6kgAAAABJRU5ErkJggg==",
  "base64",
);

describe("files of other programs", () => {
  beforeAll(async () => {
    const file = new URL("../../www/pkg/frond-exchange_bg.wasm", import.meta.url);
    await Promise.all([load(), init({ module_or_path: readFile(file) })]);
  });

  it("are told by their content, with their systems", () => {
    const found = exchange.importFile(
      bytes("one { .5 0 0 .5 0 0 -1 }\nsponge (3D) { .5 0 0 0 .5 0 0 0 .5 0 0 0 1 }\nwide { 2 0 0 2 0 0 1 }"),
    );
    expect(found.format).toBe("fractint");
    const [one, sponge, wide] = found.systems;
    expect(one).toMatchObject({
      name: "one",
      dimension: 2,
      maps: [[0.5, 0, 0, 0.5, 0, 0]],
      probabilities: [1],
    });
    expect(one?.remarks.join()).toContain("negative");
    expect(one).not.toHaveProperty("problem");
    expect(sponge).toMatchObject({ name: "sponge", dimension: 3 });
    expect(wide?.problem).toContain("no attractor");
  });

  it("come back as they were written, in every form that is a text of doubles", () => {
    const gasket = shape("gasket");
    for (const form of ["json", "fractint", "flame", "csv"] as const) {
      const { systems } = exchange.importFile(
        bytes(exchange.exportMaps({ name: "G", maps: gasket.maps }, form)),
      );
      expect(systems[0]?.maps, form).toEqual(gasket.maps);
    }
    expect(exchange.exportMaps(gasket, "latex")).toContain("\\frac{\\sqrt{3}}{4}");
    expect(exchange.exportFormats().map(({ id }) => id)).toContain("python");
  });

  it("are programs of IFStile, of several states, of objects and with views", () => {
    const half = [0.5, 0, 0, 0.5];
    const pair = "@\n$n=Pair\nA=2^-1*(A|[1,0]*B)\nB=2^-1*A\n";
    const [found] = exchange.importFile(bytes(pair)).systems;
    const states = [
      [
        { from: 0, map: [...half, 0, 0] },
        { from: 1, map: [...half, 0.5, 0] },
      ],
      [{ from: 0, map: [...half, 0, 0] }],
    ];
    expect(found).toMatchObject({ name: "Pair", dimension: 2, maps: [], states });
    const text = exchange.exportMaps({ name: "Pair", states: wrong(states) }, "aifs");
    expect(exchange.importFile(bytes(text)).systems[0]).toMatchObject({ name: "Pair", states });
    expect(refused(() => exchange.exportMaps({ states: wrong(states) }, "csv"))).toBe("export-one-state");
    expect(refused(() => exchange.exportMaps({ states: [] }, "aifs"))).toBe("export-nothing");
    expect(
      refused(() => exchange.exportMaps({ states: wrong([[{ from: 3, map: [...half, 0, 0] }]]) }, "aifs")),
    ).toBe("state");
    const two =
      "@\n$dim=3\n$root=C\nA=2^-1*([1,0,0]|[0,0,0])*A\nC=A|[9,0,0]*A\n$camera=[[0,0,-3],[0,0,0],[0,1,0],30]";
    expect(exchange.importFile(bytes(two)).systems[0]).toMatchObject({
      dimension: 3,
      objects: [{ length: 2 }, { length: 2 }],
      camera: { eye: [0, 0, -3], target: [0, 0, 0], up: [0, 1, 0], field: 30 },
    });
    expect(refused(() => exchange.importFile(bytes("@\n$dim=1000\nA=2^-1*A")))).toBe("aifs-unread");
    // Calls within calls end before the stack does.
    expect(refused(() => exchange.importFile(bytes("@f\n$a=h\nx=1\nr=f((((x))))\n@\nA=f(1)*A")))).toBe(
      "aifs-unread",
    );
  });

  it("hold a document in a picture", () => {
    const made = exchange.pngWithLink(DOT, "https://example.org/#v=1&a=fern");
    expect(exchange.importFile(made)).toMatchObject({ format: "png", systems: [], link: "v=1&a=fern" });
    expect(exchange.linkInPng(DOT)).toBeUndefined();
  });

  it("have the samples of a locus", () => {
    const bounds = { v0: 3, u0: -1, u1: 2, v1: 4 };
    const [state, gap] = [Uint8Array.of(0, 2, 0, 0), Float32Array.of(0, 0.5, 0, 0)];
    const table = "u,v,state,gap\n-1,3,0,0\n2,3,2,0.5\n-1,4,0,0\n2,4,0,0\n";
    expect(exchange.locusCsv(bounds, 2, state, gap)).toBe(table);
    // As it was once called.
    for (const four of [[-1, 2, 3, 4], Float64Array.of(-1, 2, 3, 4)])
      expect(exchange.locusCsv(four, 2, state, gap)).toBe(table);
    expect(exchange.locusNpy(bounds, 2, state, gap).slice(0, 8)).toEqual(
      Uint8Array.from(Buffer.from("\x93NUMPY\x01\0", "latin1")),
    );
  });

  it("keep the colours of their maps", () => {
    const { maps } = shape("gasket");
    const colours = ["#ff0000", "#00c0ff", "#102030"];
    for (const form of ["json", "flame"] as const) {
      const text = exchange.exportMaps({ name: "Mine", maps, colours }, form);
      expect(exchange.importFile(bytes(text)).systems[0]?.colours).toEqual(colours);
      expect(exchange.importFile(bytes(exchange.exportMaps({ maps }, form))).systems[0]).not.toHaveProperty(
        "colours",
      );
    }
    expect(exchange.exportMaps({ maps, colours }, "svg")).toContain('fill="#00c0ff"');
    expect(refused(() => exchange.exportMaps({ maps, colours: ["red"] }, "flame"))).toBe("bad-input");
  });

  it("are refused with a code and a word that helps", () => {
    expect(refused(() => exchange.importFile(bytes("")))).toBe("file-empty");
    expect(refused(() => exchange.importFile(bytes("a {\n1 2 x }")))).toBe("ifs-number");
    expect(refused(() => exchange.importFile(DOT))).toBe("file-no-link");
    expect(refused(() => exchange.exportMaps({ maps: [] }, "json"))).toBe("export-nothing");
    expect(refused(() => exchange.exportMaps({ maps: wrong([[1, 2]]) }, "json"))).toBe("bad-input");
    const [maps, probabilities] = [[[0.5, 0, 0, 0.5, 0, 0]], [0.5, 0.5]];
    expect(refused(() => exchange.exportMaps({ maps: wrong(maps), probabilities }, "json"))).toBe(
      "export-weights",
    );
    expect(refused(() => exchange.exportMaps({ maps: [[0.5, 0, 0, 0.5, 0, 0]] }, wrong("pdf")))).toBe(
      "bad-input",
    );
    expect(refused(() => exchange.pngWithLink(bytes("GIF8"), "v=1"))).toBe("bad-input");
    expect(
      refused(() => exchange.locusCsv(new Float64Array(3), 0, new Uint8Array(), new Float32Array())),
    ).toBe("bad-input");
    for (const bounds of [null, {}, { u0: 0, u1: 1, v0: 0 }, { u0: 0, u1: 1, v0: 0, v1: Number.NaN }, "abcd"])
      expect(refused(() => exchange.locusNpy(wrong(bounds), 1, Uint8Array.of(0), Float32Array.of(0)))).toBe(
        "bad-input",
      );
  });
});

import { fileURLToPath } from "node:url";
import { expect, test } from "./fixture";

/** The package's modules on a page of its own, without the studio. */
const folder = fileURLToPath(new URL("../../www/pkg/", import.meta.url));

/** What the page has beside them. */
const MADE: Record<string, { contentType: string; body: string }> = {
  "empty.html": { contentType: "text/html", body: "<!doctype html>" },
  "worker.js": {
    contentType: "text/javascript",
    body: `
      import { createLocusCompute } from "./renderer.js";
      const compute = await createLocusCompute({ software: true });
      const bounds = { u0: 0, v0: 0, u1: 0.8, v1: 0 };
      const { state } = await compute.runFamily({ sides: 2 }, { width: 9, height: 1, bounds });
      postMessage(Array.from(state));`,
  },
};

test.use({ expected: /context.*lost|device.*lost|CONTEXT_LOST|destroyed/i });

test.beforeEach(async ({ page, baseURL }) => {
  await page.route("**/pkg/*", async (route) => {
    const name = new URL(route.request().url()).pathname.split("/").at(-1) ?? "";
    const made = MADE[name];
    if (made) await route.fulfill(made);
    else await route.fulfill({ path: `${folder}${name}` });
  });
  await page.goto(`${baseURL}pkg/empty.html`);
});

type Package = typeof import("../../www/pkg/renderer.js");
type Proof = typeof import("../../www/pkg/frond-proof.js");

const gasket = [
  [0.5, 0, 0, 0.5, 0, 0],
  [0.5, 0, 0, 0.5, 0.5, 0],
  [0.5, 0, 0, 0.5, 0.25, 0.433],
];
const dragon = [
  [0.5, -0.5, 0.5, 0.5, 0, 0],
  [-0.5, 0, 0, -0.5, 1, 0],
  [0, 0.5, -0.5, 0, 0.5, 0.5],
];

test("a lost device is told once, and another draws the same", { tag: "@webgpu" }, async ({ page }, info) => {
  const seen = await page.evaluate(
    async ({ backend, maps }) => {
      const { createRenderer }: Package = await import(new URL("renderer.js", location.href).href);
      const reasons: string[] = [];
      const setUp = async () => {
        const options = { backend, onLost: (reason: string) => void reasons.push(reason) };
        const renderer = await createRenderer(document.createElement("canvas"), options);
        renderer.resize(150, 100, 2);
        renderer.setIfs(maps.flat());
        renderer.setView(0.5, 0.4, 90);
        while (!renderer.draw(1e7).settled);
        return renderer;
      };
      const pause = (milliseconds: number) => new Promise((resolve) => setTimeout(resolve, milliseconds));
      const first = await setUp();
      const before = Array.from(await first.readPixels());
      first.forceLoss();
      // All calls are allowed, and do nothing.
      first.resize(30, 30);
      first.setView(0, 0, 1);
      const { complete, settled } = first.draw(1e6);
      const refused = await first.readPixels().then(
        () => false,
        () => true,
      );
      while (reasons.length === 0) await pause(5);
      await pause(30);
      const told = reasons.length;
      const second = await setUp();
      first.free();
      const after = Array.from(await second.readPixels());
      second.free();
      await pause(30);
      const same = before.length === after.length && before.every((byte, i) => byte === after[i]);
      const lit = before.filter((byte, i) => i % 4 === 3 && byte > 0).length;
      return { lit, complete, settled, refused, told, same, finally: reasons.length };
    },
    { backend: info.project.name as "webgl2" | "webgpu", maps: gasket },
  );
  expect(seen.lit).toBeGreaterThan(500);
  // Letting go of a device is no loss.
  expect(seen).toMatchObject({
    complete: false,
    settled: true,
    refused: true,
    told: 1,
    same: true,
    finally: 1,
  });
});

test("what is no canvas and what are no maps is refused", { tag: "@webgpu" }, async ({ page }, info) => {
  const codes = await page.evaluate(
    async (backend) => {
      const { createRenderer }: Package = await import(new URL("renderer.js", location.href).href);
      const code = async (call: () => unknown) => {
        try {
          await call();
        } catch (problem) {
          return (problem as { code: string }).code;
        }
        return "not refused";
      };
      const create = (canvas: unknown) => () => createRenderer(canvas as HTMLCanvasElement, { backend });
      // A canvas that has another context already.
      const taken = document.createElement("canvas");
      taken.getContext("2d");
      const renderer = await create(document.createElement("canvas"))();
      return [
        await code(create(undefined)),
        await code(create(5)),
        await code(create({})),
        await code(create(taken)),
        await code(() => renderer.setIfs([0.5, 0.5, 0.5, 0.5, 0.5])),
        await code(() => renderer.setIfs([])),
        await code(() => renderer.setIfs([1, 0, 0, 1, 0, 0])),
        await code(() => renderer.setIfs([0.5, 0, 0, 0.5, 0, 0], [1, 1])),
        await code(() => renderer.setView(0, 0, 0)),
        await code(() => renderer.setStyle({ palette: ["red"] })),
        (await code(() => renderer.readPixels())) === "not refused",
      ];
    },
    info.project.name as "webgl2" | "webgpu",
  );
  expect(codes).toEqual([
    "bad-input",
    "bad-input",
    "bad-input",
    "no-gpu",
    "bad-input",
    "no-maps",
    "no-attractor",
    "probabilities",
    "bad-input",
    "bad-input",
    false,
  ]);
});

test.describe("a card that computes", { tag: "@webgpu" }, () => {
  test.beforeEach(({ page: _ }, info) => test.skip(info.project.name !== "webgpu", "only WebGPU computes"));

  test("decides everything together with the processor", async ({ page }) => {
    const seen = await page.evaluate(
      async ({ from, to }) => {
        const { createLocusCompute }: Package = await import(new URL("renderer.js", location.href).href);
        const proof: Proof = await import(new URL("frond-proof.js", location.href).href);
        await proof.default();
        const compute = await createLocusCompute({ software: true });
        if (!compute) throw new Error("there is no WebGPU");
        // Fine enough that the card leaves some.
        const options = { width: 61, height: 40, epsilon: 1e-5 };
        const ends = [{ maps: from }, { maps: to }] as unknown as Parameters<typeof compute.run>;
        const run = compute.run(ends[0], ends[1], options);
        // What is under way is finished all the same.
        compute.free();
        const first = await run;
        // In two slices.
        const part = proof.settleLocus(ends[0], ends[1], { ...options, most: 5 }, first.state, first.gap);
        const whole = proof.settleLocus(ends[0], ends[1], options, part.state, part.gap);
        const truth = proof.locus(ends[0], ends[1], options);
        const wrong = Array.from(truth.state, (state, k) => {
          const [gap, trueGap] = [whole.gap[k] ?? Number.NaN, truth.gap[k] ?? Number.NaN];
          const near = Math.max(gap, trueGap) < 3e-5;
          const same = (whole.state[k] ?? 9) < 2 === state < 2;
          return near || (same && Math.abs(gap - trueGap) <= 0.6 * trueGap) ? "" : `${k}: ${gap} ${trueGap}`;
        });
        return {
          time: first.milliseconds,
          lengths: [first.state.length, first.gap.length],
          left: first.left,
          open: first.state.filter((code) => code === 3).length,
          after: [part.left, whole.left],
          wrong: wrong.filter((text) => text !== ""),
        };
      },
      { from: dragon, to: gasket },
    );
    expect(seen.time).toBeGreaterThan(0);
    expect(seen.lengths).toEqual([2440, 2440]);
    expect(seen.open).toBe(seen.left);
    expect(seen.left).toBeGreaterThan(0);
    expect(seen.left).toBeLessThan(200);
    expect(seen.after).toEqual([seen.left - 5, 0]);
    expect(seen.wrong).toEqual([]);
  });

  test("refuses what it cannot do", async ({ page }) => {
    const codes = await page.evaluate(async (maps) => {
      const { createLocusCompute }: Package = await import(new URL("renderer.js", location.href).href);
      const compute = await createLocusCompute({ software: true });
      if (!compute) throw new Error("there is no WebGPU");
      type Call = (...all: unknown[]) => Promise<unknown>;
      const code = async (call: Promise<unknown>) =>
        call.then(
          () => "not refused",
          (problem: { code: string }) => problem.code,
        );
      const run = (from: unknown, options: object) =>
        code((compute.run as unknown as Call).call(compute, from, { maps }, options));
      return [
        await run({ maps }, { width: 0, height: 4 }),
        await run({ maps: maps.slice(0, 2) }, { width: 4, height: 4 }),
        await run({ maps }, { width: 4, height: 4, epsilon: 1e-9 }),
        await run(undefined, { width: 4, height: 4, epsilon: 1e-9 }),
        await run({ maps }, { width: 8192, height: 8192 }),
        await code(
          (compute.runFamily as unknown as Call).call(compute, { sides: 9 }, { width: 4, height: 4 }),
        ),
      ];
    }, gasket);
    expect(codes).toEqual([
      "locus-size",
      "map-counts",
      "single-fine",
      "bad-input",
      "gpu-size",
      "single-maps",
    ]);
  });

  test("does so in a worker, too", async ({ page }) => {
    const states = await page.evaluate(async () => {
      const worker = new Worker(new URL("worker.js", location.href), { type: "module" });
      return new Promise<number[]>((resolve, reject) => {
        worker.onmessage = ({ data }) => resolve(data);
        worker.onerror = ({ message }) => reject(new Error(message));
      });
    });
    // s z - 1 and s z + 1 over real s: two points at 0, a segment from 1/2 on, certain from the root of 1/2 on.
    expect(states).toEqual([2, 2, 2, 2, 2, 1, 1, 1, 0]);
  });
});

/** The whole package, as the build writes it. */
const built = fileURLToPath(new URL("../../target/package/frond/", import.meta.url));
const ELSEWHERE = "http://elsewhere.example/frond/";

test("the package's pool works from plain files, and from another host", async ({ page, baseURL }) => {
  const answer = { headers: { "access-control-allow-origin": "*" } };
  await page.route(/\/frond\/[\w.-]+$/, (route) =>
    route.fulfill({
      ...answer,
      path: `${built}${new URL(route.request().url()).pathname.split("/").at(-1)}`,
    }),
  );
  for (const folder of [`${baseURL}frond/`, ELSEWHERE]) {
    const seen = await page.evaluate(
      async ({ folder, from, to }) => {
        const { createPool }: typeof import("../../crate/xtask/src/package/entries/pool.js") = await import(
          `${folder}pool.js`
        );
        const pool = createPool({ size: 2 });
        const shares: number[] = [];
        const how = { onProgress: (share: number) => void shares.push(share) };
        const [a, b] = [{ maps: from }, { maps: to }] as [never, never];
        const locus = await pool.locus(a, b, { width: 31, height: 31 }, how);
        const { verdict } = await pool.connectedness(a, undefined);
        pool.close();
        return {
          samples: locus.state.length,
          seen: new Set(locus.state).size > 1,
          verdict,
          last: shares.at(-1),
        };
      },
      { folder, from: dragon, to: gasket },
    );
    expect(seen).toEqual({ samples: 961, seen: true, verdict: "connected", last: 1 });
  }
});

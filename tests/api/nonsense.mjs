/**
 * Calls every function of every entry of the package with nonsense, in a thread of its own: node nonsense.mjs <folder
 * of the package> <signatures.json>. Prints what each function did that it must not do, as JSON.
 */
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";

/** A call that takes longer is given up. */
const MOST_MS = Number(process.env.FROND_MOST_MS ?? 60_000);

const gasket = () => ({
  maps: [
    [0.5, 0, 0, 0.5, 0, 0],
    [0.5, 0, 0, 0.5, 0.5, 0],
    [0.5, 0, 0, 0.5, 0.25, 0.433],
  ],
});
const rows3 = () =>
  [
    [0, 0, 0],
    [0.5, 0, 0],
    [0, 0.5, 0],
    [0, 0, 0.5],
  ].map((shift) => [0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5, ...shift]);
const square = () => ({
  knots: [
    [0, 0],
    [1, 0],
    [1, 1],
    [0, 1],
  ],
  edges: [null, { from: 2, span: 2, reversed: false, c: 0.3 }, null, null],
});
const round = () => Array.from({ length: 64 }, (_, i) => (i % 2 ? Math.sin : Math.cos)((i >> 1) / 5.1));
const wave = () => Array.from({ length: 120 }, (_, i) => (i % 2 ? Math.sin((i >> 1) / 5) : i >> 1));
const pixels = () =>
  Array.from({ length: 16 * 16 * 4 }, (_, i) =>
    (i >> 2) % 16 > 4 && (i >> 6) % 16 > 4 && i % 4 < 3 ? 0 : 255,
  );
const bend = () => ({
  columns: 2,
  rows: 2,
  box: [0, 0, 1, 1],
  moves: [0, 0, 0.1, 0, 0, 0, 0, 0],
  kb: 0,
  ke: 3,
  delta: 0.5,
  spin: "none",
  continuity: "auto",
  superposed: true,
});

/** What takes a while is made once, and handed out as a copy. */
const once = (make) => {
  let made;
  return () => {
    made ??= make();
    return structuredClone(made);
  };
};

/** Right arguments: by function, by type, or by the name of a parameter. `entries` are the modules. */
function samples(entries) {
  const { draw, curve, fit, space, directed, exchange, proof } = entries;
  const graph = () =>
    curve.interpolation(
      [
        [0, 0],
        [1, 0.5],
        [2, 0],
      ],
      { c: [0.3, 0.2] },
    );
  const view = () => space.defaultView(space.defaultSpace());
  const shaded = () => space.defaultSpace().light;
  const light = () => space.defaultSpace().light;
  const look = () => ({ width: 8, height: 8, factor: 1, palette: ["#112233"], ground: "#ffffff" });
  const locus = () => proof.locus(gasket(), gasket(), { width: 7, height: 7 });
  const spline = once(() => fit.fitWithin(round(), 60).word);
  const states = () => directed.directedPresets()[0].system;
  return {
    types: {
      Ifs: gasket,
      MapRow: () => [0.5, 0, 0, 0.5, 0, 0.1],
      MapRow3: () => rows3()[1],
      Point3: () => [0.1, 0.2, 1],
      PathPoint: () => [0.4, 0.5],
      Curve: square,
      Graph: graph,
      Bend: bend,
      Scene: () => draw.defaultScene(),
      Space: () => space.defaultSpace(),
      SpaceView: view,
      SpaceLight: light,
      SpaceShown: () => ({ maps: rows3() }),
      PlaneGraph: () =>
        curve.interpolationCurve(
          [
            [0, 0, 0],
            [1, 0.5, 1],
            [2, 0, 0],
          ],
          {
            factors: [
              [0.3, 0, 0, 0.3],
              [0.2, 0, 0, 0.2],
            ],
          },
        ),
      PolygonFamily: () => ({ sides: 3 }),
      FamilyOptions: () => ({ bounds: { u0: -1, v0: -1, u1: 1, v1: 1 }, width: 7, height: 7 }),
      LocusOptions: () => ({ width: 7, height: 7 }),
      Locus: locus,
      DirectedIfs: states,
      DigitSystem: () => ({
        matrix: [2, 0, 0, 2],
        digits: [
          [0, 0],
          [1, 0],
          [0, 1],
        ],
      }),
      MeshOptions: () => ({ fineness: 16, size: 40 }),
      IndexBufferOptions: () => ({ size: 20, points: 2000 }),
      MaskOptions: () => ({ threshold: 0, petiole: "keep", strokes: [] }),
      CollageOptions: () => ({ maps: 6, features: 31, separable: false, tied: false, partitioned: false }),
      DirectedRasterOptions: () => ({ width: 9, height: 9 }),
      RasterOptions: () => ({ width: 9, height: 9 }),
      PathOptions: () => ({ size: 13 }),
      HoughOptions: () => ({ cells: 3 }),
      HoughCandidate: once(() => {
        const { found } = fit.houghMaps(wave(), wave(), { cells: 3 });
        return found.find(({ candidate }) => candidate)?.candidate;
      }),
      Certificate: once(() =>
        proof.certificate({
          maps: [
            [0.3, 0, 0, 0.3, 0, 0],
            [0.3, 0, 0, 0.3, 0.7, 0],
          ],
        }),
      ),
      ConnectedCertificate: once(() => proof.connectedCertificate(gasket())),
    },
    names: {
      points: round,
      outline: round,
      coarse: wave,
      fine: wave,
      pixels,
      rgba: pixels,
      width: () => 16,
      height: () => 16,
      text: () => "a=fern&b=tree",
      link: () => "a=fern&b=tree",
      packed: spline,
      word: spline,
      numbers: () => 12,
      bytes: () => 60,
      count: () => 20,
      sides: () => 3,
      method: () => "squares",
      kind: () => "oak",
      name: () => "one",
      png: () => exchange.pngWithLink(new Uint8Array(Buffer.from(PNG, "base64")), "a=fern"),
      most: () => 300,
      state: () => new Uint8Array(49),
      gap: () => new Float32Array(49),
      peaks: () => [],
      map: () => [0.5, 0, 0.5, 0, 0],
      bounds: () => ({ u0: -1, v0: -1, u1: 2, v1: 2 }),
      palette: () => [0x112233],
      stride: () => 1,
      r0: () => 0,
      r1: () => 2,
      x0: () => 0,
      y0: () => 0,
      x1: () => 2,
      y1: () => 2,
      first: () => true,
      budget: () => 1000,
      scale: () => 8,
      milliseconds: () => 1,
      code: () => [0, 1, 2, 0],
      symbols: () => 3,
      kb: () => 0,
      ke: () => 3,
      codes: () => [[0, 1]],
      tails: () => [[0.1, 0.2]],
      view: () => ({ tolerance: 0.01 }),
      part: () => 0,
      parts: () => 1,
      epsilon: () => 0.1,
      angle: () => 0.3,
      seconds: () => 0.5,
      look,
      smoothing: () => 0.1,
      steps: () => 2,
      triangles: () => 10,
      counts: undefined,
      cells: () => new Uint32Array([1]),
      component: () => 0,
      picks: () => [{ map: [0.5, 0, 0.5, 0, 0], domain: [0, 10] }],
      box: () => [0, 0, 1, 1],
      tolerance: () => 0.1,
      objects: () => [{ maps: rows3() }],
      transform: () => [1, 0, 0, 1, 1, 1],
      by: () => rows3()[1],
      shift: () => ({ numerators: [1, 0], denominator: 3 }),
    },
    functions: {
      unpackCurve: () => [curve.packCurve(square())],
      unpackSpace: () => [space.packSpace(space.defaultSpace())],
      parseIfs3: () => [space.writeIfs3("one", rows3())],
      countFlat: () => [space.writeIfs3("one", rows3())],
      importFile: () => [new TextEncoder().encode("0.5 0 0 0.5 0 0\n0.5 0 0 0.5 0.5 0\n")],
      exportMaps: () => [gasket(), "csv"],
      checkCertificate: () => [
        proof.certificate({
          maps: [
            [0.3, 0, 0, 0.3, 0, 0],
            [0.3, 0, 0, 0.3, 0.7, 0],
          ],
        }),
      ],
      pngWithLink: () => [new Uint8Array(Buffer.from(PNG, "base64")), "a=fern"],
      settleLocus: () => [
        gasket(),
        gasket(),
        { width: 7, height: 7 },
        new Uint8Array(49),
        new Float32Array(49),
      ],
      familyMaps: () => [{ sides: 3 }, [0.5, 0.1]],
      fitCurve: () => [round(), { numbers: 12 }],
      planPath: () => [gasket(), gasket(), { size: 7 }],
      "new PathSearch": () => [gasket(), gasket(), { size: 7 }],
      rateCandidate: () => [gasket(), gasket(), { size: 7 }],
      findPath3: () => [rows3(), rows3(), { size: 5 }],
      barnsleyTest: () => [gasket(), { iterations: 3 }],
      hausdorffDistance: () => [gasket(), gasket(), { budget: 1000 }],
      attractor: () => [gasket(), { points: 50 }],
      attractor3: () => [rows3(), { points: 50 }],
      shadow: () => [rows3(), [0, 0, 1], { points: 50 }],
      directedAttractor: () => [states(), { points: 50 }],
      interpolate: () => [gasket(), gasket(), { u: 0.5, v: 0.5 }],
      interpolate3: () => [rows3(), rows3(), { u: 0.5, v: 0.5 }],
      interpolateDirected: () => [states(), states(), { u: 0.5, v: 0.5 }],
      interpolation: () => [
        [
          [0, 0],
          [1, 0.5],
          [2, 0],
        ],
        { c: [0.3, 0.2] },
      ],
      interpolationCurve: () => [
        [
          [0, 0, 0],
          [1, 0.5, 1],
          [2, 0, 0],
        ],
        {
          factors: [
            [0.3, 0, 0, 0.3],
            [0.2, 0, 0, 0.2],
          ],
        },
      ],
      sampleInterpolationCurve: (sample) => [sample.types.PlaneGraph()],
      toRecurrent: (sample) => [sample.types.Graph(), 64],
      exactly: undefined,
      readNumbers: () => [["1/3", "sqrt(2)"]],
      proveExact: () => [gasket(), ["1/3"]],
      analyze: () => [gasket(), ["1/3"], { budget: 100 }],
      certifyDirected: () => [states(), states(), { moments: 3 }],
      intersection3: () => [rows3(), rows3(), { points: 20 }],
      houghAssemble: (sample) => [wave(), wave(), [sample.types.HoughCandidate()].filter(Boolean)],
      "new Sheet": () => [new Uint8Array(pixels()), 16, 16],
      "Sheet.draw": () => [bend(), 2, { width: 9, height: 9 }],
      "new DirectedLocus": () => [states(), states(), { width: 5, height: 5 }],
      "new SpaceLocus": () => [rows3(), rows3(), { width: 5, height: 5 }],
      "LocusTiles.prove": () => [0, 0, 2, 2, new Uint8Array(4)],
      "FamilyTiles.prove": () => [0, 0, 2, 2, new Uint8Array(4)],
      settleFamily: (sample) => [
        { sides: 3 },
        sample.types.FamilyOptions(),
        new Uint8Array(49),
        new Float32Array(49),
      ],
      "HoughFirst.add": () => [new Uint32Array(128 ** 3)],
      "SpacePicture.carve": () => [view(), 8, 8],
      "SpacePicture.carveRows": () => [view(), 8, 8, 2, 6, 1],
      "SpacePicture.carveLamp": () => [view(), shaded(), 64, 64, 0, 8],
      "SpacePicture.lampSide": () => [view(), shaded(), 8, 8],
      "SpacePicture.lightReach": () => [view(), shaded(), 1],
      "SpacePicture.lightRows": () => [
        view(),
        { ...shaded(), shadows: 0 },
        { width: 8, height: 8, factor: 1, palette: [], ground: "#101418" },
        { top: 0, rows: [2, 6] },
        new Float32Array(64).fill(5),
        new Uint32Array(64).fill(1),
        new Float32Array(0),
        1,
      ],
      "SpacePicture.clouds": () => [100],
      "SpaceMesh.file": () => ["stl", ["#112233"]],
      locusCsv: () => [plane, 7, new Uint8Array(49), new Float32Array(49)],
      locusNpy: () => [plane, 7, new Uint8Array(49), new Float32Array(49)],
      meshBytes: () => ["stl", 10],
      "PictureTracer.outline": () => [0],
      traceOutline: () => [pixels(), 16, 16],
      rivalFit: () => [round(), "split", 20],
      meshGrid: () => [bend(), 4],
      rasterize: () => [gasket(), { width: 9, height: 9 }],
      "LinkedMorph.draw": () => [
        { u: 0.5, v: 0.5, w: 0, width: 9, height: 9, x: 0.5, y: 0.5, scale: 9 },
        [0x112233],
      ],
    },
  };
}

const PNG =
  "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";

/** How one that no `new` makes, or that needs work before it answers, comes to be. */
const made = (entries, sample) => ({
  SpaceCarve: () => {
    const carve = new entries.space.SpacePicture([{ maps: rows3() }]).carve(sample.types.SpaceView(), 8, 8);
    while (!carve.run(10_000));
    return carve;
  },
  SpaceMesh: () => {
    const mesher = new entries.space.SpaceMesher([{ maps: rows3() }], { fineness: 16, size: 40 });
    while (!mesher.run(100_000));
    return mesher.finish();
  },
  SpaceMesher: () => {
    const mesher = new entries.space.SpaceMesher([{ maps: rows3() }], { fineness: 16, size: 40 });
    while (!mesher.run(100_000));
    return mesher;
  },
  PictureTracer: () => {
    const tracer = new entries.fit.PictureTracer(16, 16, pixels());
    tracer.mask(sample.types.MaskOptions());
    return tracer;
  },
  SplineFit: () => {
    const fit = new entries.fit.SplineFit(round(), 60);
    while (!fit.step(100).done);
    return fit;
  },
});

const plane = { u0: -1, v0: -1, u1: 2, v1: 2 };

const deep = () => {
  let inner = [];
  for (let i = 0; i < 20_000; i++) inner = [inner];
  return inner;
};

const NONSENSE = [
  () => undefined,
  () => null,
  () => ({}),
  () => [],
  () => "x",
  () => "",
  () => 0,
  () => -1,
  () => Number.NaN,
  () => Infinity,
  () => 1e9,
  () => 2,
  () => 2.5,
  () => 10n,
  () => () => 1,
  () => Symbol("x"),
  () => true,
  () => new Array(5),
  () => new Array(1e9),
  () => Object.freeze([1, 2, 3]),
  () => [
    [0, 1],
    [2, 3],
  ],
  () => [1, 2, 3, 4, 5, 6, 7],
  () => new Uint8Array(3),
  () => new Float64Array([Number.NaN, 1]),
  () => new Date(0),
  () => ({ length: 1e9 }),
  () => "é".repeat(1000),
  () => "%%%&&==",
  deep,
  () => new Map([[1, 2]]),
  () => Object.freeze({ maps: Object.freeze([]) }),
  () => new DataView(new ArrayBuffer(8)),
  () => [null, undefined, "1"],
  () => -0,
];

/** Each of their calls that works takes seconds: what is mostly refused is tried, and no more. */
const SLOW = new Set([
  "boxes3",
  "findPath3",
  "planPath",
  "rateCandidate",
  "routes",
  "ways",
  "fitCurve",
  "fitWithin",
  "new SplineFit",
  "SplineFit.step",
  "SplineFit.best",
  "SplineFit.measured",
]);
const REFUSED = [4, 8, 13, 15, 20, 27];

/** What takes that long because it is asked for that much. */
const LONG =
  /^(?:indexBuffer|attractor3?|shadow|directedAttractor|intersection3|barnsleyTest)\b.*\b(?:points|iterations)\b.*1000000000/;

/** The value with one place of it, at any depth, put out of order: as many copies as there are places, to a limit. */
function* broken(value, most = 5) {
  const places = [];
  const walk = (at, path) => {
    if (places.length > most || typeof at !== "object" || at === null || ArrayBuffer.isView(at)) return;
    for (const key of Object.keys(at).slice(0, 9)) {
      places.push([...path, key]);
      walk(at[key], [...path, key]);
    }
  };
  walk(value, []);
  for (const path of places.slice(0, most)) {
    for (const [i, nonsense] of NONSENSE.entries()) {
      const copy = structuredClone(value);
      let at = copy;
      for (const key of path.slice(0, -1)) at = at[key];
      at[path.at(-1)] = nonsense();
      yield [`${path.join(".")} = ${said(nonsense(), i)}`, copy];
    }
  }
  if (Array.isArray(value) && value.length > 0) {
    yield ["one more", [...value, value[0]]];
    yield ["one less", value.slice(1)];
  }
}

const said = (value, i) => {
  if (typeof value === "number" || value === undefined || value === null) return String(value);
  return `nonsense ${i}`;
};

async function all({ folder, signatures, shared, from }) {
  const entries = {};
  let FrondError;
  for (const [entry] of signatures) {
    entries[entry] = await import(pathToFileURL(`${folder}/node/${entry}.js`));
    await entries[entry].default();
    FrondError ??= entries[entry].FrondError;
  }
  const sample = samples(entries);
  const objects = made(entries, sample);
  const watch = new Int32Array(shared);
  const tell = (problem) => parentPort.postMessage({ problem });
  /** A right value for a parameter. */
  const right = ({ name, type }) => {
    if (type.named && sample.types[type.named]) return sample.types[type.named]();
    if (type.list?.named && sample.types[type.list.named])
      return type.list.named === "MapRow3"
        ? rows3()
        : type.list.named === "MapRow"
          ? gasket().maps
          : [sample.types[type.list.named]()];
    if (sample.names[name]) return sample.names[name]();
    if (type === "number") return 0.5;
    if (type === "string") return "x";
    if (type === "boolean") return true;
    const one = type.any?.find((each) => each.named && sample.types[each.named]);
    if (one) return sample.types[one.named]();
    return undefined;
  };
  const argumentsOf = (label, parameters) =>
    sample.functions[label]?.(sample) ??
    parameters.map((parameter) => (parameter.optional ? undefined : right(parameter)));
  let number = 0;
  let calls = 0;
  for (const [entry, functions] of signatures) {
    for (const { label, parameters, name, of } of functions) {
      number++;
      if (number <= from) continue;
      const module = entries[entry];
      const made =
        of &&
        (() =>
          objects[of]?.() ??
          new module[of](
            ...argumentsOf(
              `new ${of}`,
              signatures.find(([one]) => one === entry)[1].find((one) => one.label === `new ${of}`)
                .parameters,
            ),
          ));
      const call = (args, self) =>
        label.startsWith("new ")
          ? new module[name](...args)
          : of
            ? self[name](...args)
            : module[name](...args);
      const attempt = async (what, args, mayFail) => {
        Atomics.add(watch, 0, 1);
        calls++;
        parentPort.postMessage({ at: `${number} ${label} ${what}` });
        let self;
        try {
          self = made?.();
        } catch (problem) {
          tell(`${label} cannot be called any more, at ${what}: ${problem?.code} ${problem?.message}`);
          return false;
        }
        try {
          const answer = await call(args, self);
          if (typeof answer?.free === "function") answer.free();
          if (self && name !== "free") self.free();
          return true;
        } catch (problem) {
          const words = `${label}(${what}): ${problem?.name} ${problem?.code}: ${String(problem?.message).split("\n")[0]}`;
          if (!mayFail) tell(`it fails where it should not: ${words}`);
          else if (!(problem instanceof FrondError)) tell(`not a FrondError: ${words}`);
          else if (problem.code === "broken") tell(`broken: ${words}`);
          else if (
            /\bstruct\b|\b[fiu](?:32|64)\b|usize|unit value|\brust\b|unreachable|null pointer|panick|JsValue|undefined is|sequence|missing field|invalid type/i.test(
              problem.message,
            ) ||
            problem.message.length < 15
          )
            tell(`the words: ${words}`);
          return false;
        }
      };
      Atomics.add(watch, 0, 1);
      const args = () => argumentsOf(label, parameters);
      await attempt("right arguments", args(), false);
      await attempt(
        "null for what is optional",
        args().map((each) => each ?? null),
        false,
      );
      await attempt("nothing at all", [], true);
      for (const [i] of parameters.entries()) {
        for (const [k, nonsense] of NONSENSE.entries()) {
          if (SLOW.has(label) && !REFUSED.includes(k)) continue;
          const given = args();
          given[i] = nonsense();
          const what = `${parameters[i].name} = ${said(given[i], k)}`;
          if (!LONG.test(`${label} ${what}`)) await attempt(what, given, true);
        }
        const value = args()[i];
        if (
          SLOW.has(label) ||
          typeof value !== "object" ||
          value === null ||
          ArrayBuffer.isView(value) ||
          value.length > 40
        )
          continue;
        for (const [place, copy] of broken(value)) {
          const given = args();
          given[i] = copy;
          const what = `${parameters[i].name}.${place}`;
          if (!LONG.test(`${label} ${what.replace("= 1e9", "1000000000")}`)) await attempt(what, given, true);
        }
      }
      await attempt("right arguments again", args(), false);
      parentPort.postMessage({ done: number });
    }
  }
  parentPort.postMessage({ calls });
}

if (isMainThread) {
  const [folder, file] = process.argv.slice(2);
  const signatures = JSON.parse(readFileSync(file, "utf8"));
  const problems = [];
  let calls = 0;
  let from = Number(process.argv[4] ?? 0);
  for (;;) {
    const shared = new SharedArrayBuffer(4);
    const worker = new Worker(new URL(import.meta.url), {
      workerData: { folder, signatures, shared, from },
      stdout: true,
      stderr: true,
    });
    let at = "";
    const ended = new Promise((resolve) => {
      worker.on("message", (message) => {
        if (message.problem) {
          problems.push(message.problem);
          if (process.env.FROND_TELL) process.stderr.write(`${message.problem}\n`);
        }
        if (message.at) at = message.at;
        if (process.env.FROND_TELL && message.done) process.stderr.write(`${at} ${problems.length}\n`);
        if (message.done) from = message.done;
        if (message.calls) calls = message.calls;
      });
      worker.on("error", (problem) => problems.push(`the thread died at ${at}: ${problem?.stack}`));
      worker.on("exit", () => resolve(false));
    });
    let seen = -1;
    let stall;
    const stalled = new Promise((resolve) => {
      stall = setInterval(() => {
        const now = Atomics.load(new Int32Array(shared), 0);
        if (process.env.FROND_TELL) process.stderr.write(`${now} ${at}\n`);
        if (now === seen) resolve(true);
        seen = now;
      }, MOST_MS);
    });
    const hung = await Promise.race([ended, stalled]);
    clearInterval(stall);
    if (!hung && calls > 0) break;
    if (hung) problems.push(`it hangs: ${at}`);
    from = Number(at.split(" ")[0]);
    await worker.terminate();
  }
  process.stdout.write(JSON.stringify({ calls, problems }), () => process.exit());
} else await all(workerData);

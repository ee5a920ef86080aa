/** The command of the package, as it is installed: what it writes is read by others. */
import { execFileSync, spawn, spawnSync } from "node:child_process";
import { once } from "node:events";
import { existsSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { crc32, deflateSync, inflateSync } from "node:zlib";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { commandIn, PACKING_MS, type Packed, packed, root } from "./packed";

let made: Packed;
let app: string;
let node: Packed["node"];
let frond: ReturnType<typeof commandIn>["frond"];
let frondBeside: ReturnType<typeof commandIn>["frondBeside"];
let given: ReturnType<typeof commandIn>["given"];
let bytes: ReturnType<typeof commandIn>["bytes"];
let sides: ReturnType<typeof commandIn>["sides"];
let command: string;
let beside: ReturnType<typeof commandIn>["beside"];

beforeAll(async () => {
  made = await packed();
  ({ app, node } = made);
  ({ frond, frondBeside, given, bytes, sides, command, beside } = commandIn(app));
}, PACKING_MS);

afterAll(() => made.drop());

const link = "a=dragon-3&b=gasket&path=straight";
const size = ["--width", "60", "--height", "40"];
const DUST = '{ "maps": [[0.3,0,0,0.3,0,0],[0.3,0,0,0.3,0.7,0]] }';
/** A gasket as Fractint writes it. */
const GASKET = "Gasket {\n .5 0 0 .5 0 0 .33\n .5 0 0 .5 .5 0 .33\n .5 0 0 .5 .25 .433 .34\n}\n";
/** Milliseconds for as many calls as it takes. */
const SLOW_MS = 300_000;
const python = spawnSync("python3", ["--version"]).status === 0;

/** The rows of a PNG before they are packed; its link and packing left aside. */
function pixelsOf(file: Buffer): Buffer {
  const packed: Buffer[] = [];
  for (let at = 8; at < file.length; at += 12 + file.readUInt32BE(at))
    if (file.toString("latin1", at + 4, at + 8) === "IDAT")
      packed.push(file.subarray(at + 8, at + 8 + file.readUInt32BE(at)));
  return inflateSync(Buffer.concat(packed));
}

/** A PNG of one byte a pixel, as the specification has it. */
function greyPng(width: number, height: number, grey: (x: number, y: number) => number): Buffer {
  const chunk = (type: string, data: Buffer) => {
    const body = Buffer.concat([Buffer.from(type, "latin1"), data]);
    const [length, check] = [Buffer.alloc(4), Buffer.alloc(4)];
    length.writeUInt32BE(data.length);
    check.writeUInt32BE(crc32(body));
    return Buffer.concat([length, body, check]);
  };
  const head = Buffer.alloc(13);
  head.writeUInt32BE(width, 0);
  head.writeUInt32BE(height, 4);
  head[8] = 8;
  const rows = Array.from({ length: height }, (_, y) =>
    Buffer.from([0, ...Array.from({ length: width }, (_, x) => grey(x, y))]),
  );
  const parts = [
    chunk("IHDR", head),
    chunk("IDAT", deflateSync(Buffer.concat(rows))),
    chunk("IEND", Buffer.alloc(0)),
  ];
  return Buffer.concat([Buffer.from("\x89PNG\r\n\x1a\n", "latin1"), ...parts]);
}

describe("the command", () => {
  it("has a command that draws morphs as pictures, films and frames", () => {
    expect(frond("render", link, "--out", "x.png", "--t", "0.5", ...size).status).toBe(0);
    expect(sides("x.png")).toEqual([60, 40]);
    // The picture holds its link, and so opens as maps.
    expect(JSON.parse(frond("export", "x.png", "--as", "json").stdout).maps ?? []).not.toEqual([]);
    for (const [file, starts] of [
      ["x.gif", "GIF89a"],
      ["x.zip", "PK"],
      ["x.apng", "\x89PNG"],
    ] as const) {
      const film = ["--seconds", "0.3", "--fps", "10", "--background", "#ffffff"];
      expect(frond("render", link, "--out", file, ...film, ...size)).toMatchObject({ status: 0 });
      expect(bytes(file).toString("latin1", 0, starts.length)).toBe(starts);
    }
    expect(frond("render", link, "--out", "n.png", "--frames", "3", ...size).status).toBe(0);
    expect(
      ["n-0001.png", "n-0002.png", "n-0003.png", "n-0004.png", "n.png"].map((file) =>
        existsSync(join(app, file)),
      ),
    ).toEqual([true, true, true, false, false]);
    expect(sides("n-0003.png")).toEqual([60, 40]);
    expect(bytes("n-0001.png").equals(bytes("n-0002.png"))).toBe(false);
    // Two frames more stand still at each end; the one in the middle is the same, however it goes.
    const paced = ["--frames", "3", "--fps", "10", "--hold", "0.2", "--ease", "in-out"];
    expect(frond("render", link, "--out", "p.png", ...paced, ...size).stderr).toContain("7 frames");
    const like = [1, 1, 1, 2, 3, 3, 3].map((frame) => bytes(`n-000${frame}.png`));
    like.forEach((frame, i) => {
      expect(bytes(`p-000${i + 1}.png`).equals(frame)).toBe(true);
    });
    const drawing = frond("render", link, "--out", "x.svg", "--t", "1");
    expect(drawing).toMatchObject({
      status: 0,
      stderr: expect.stringMatching(/^x\.svg: \d+ pieces of one size in 3 paths/),
    });
    expect(bytes("x.svg").toString().match(/<path/g)).toHaveLength(3);
  });

  it("draws bends and space as well", () => {
    const bent = "a=gasket&b=gasket&path=straight&tool=deform&mesh=4x4:0,0,1,1&keys=0:;0.5:6,0.2,0";
    expect(frond("render", bent, "--out", "bent.png", "--frames", "2", ...size).status).toBe(0);
    // The second key is half way round.
    expect(bytes("bent-0001.png").equals(bytes("bent-0002.png"))).toBe(false);
    expect(frond("render", bent, "--out", "bent.png", "--t", "0.5", ...size).status).toBe(0);
    expect(sides("bent.png")).toEqual([60, 40]);
    expect(frond("render", bent, "--out", "bent.svg").stderr).toMatch(/nothing bends/);
    const states = "directed-a=frond&directed-b=snowflake&mode=linear";
    expect(frond("render", states, "--out", "s.png", "--frames", "2", ...size)).toMatchObject({ status: 0 });
    expect(bytes("s-0001.png").equals(bytes("s-0002.png"))).toBe(false);
    const made = node(`
      import init, { defaultSpace, defaultView, packSpace } from "frond-ifs/space";
      await init();
      const space = defaultSpace();
      const view = defaultView(space);
      const keys = [0, 2].map((at) => ({ at, ease: "even", view: { ...view, turn: view.turn + at } }));
      const packed = packSpace({ ...space, timeline: { seconds: 2, loop: "once", course: "straight", keys } });
      console.log("tool=space&space=" + packed);`).trim();
    expect(frond("render", made, "--out", "space.png", "--frames", "2", ...size)).toMatchObject({
      status: 0,
    });
    expect(bytes("space-0001.png").equals(bytes("space-0002.png"))).toBe(false);
    const still = frond("render", "tool=space", "--out", "still.gif", ...size);
    expect(still).toMatchObject({
      status: 2,
      stderr: expect.stringMatching(/nothing to film: .*stands still/),
    });
    expect(frond("render", "tool=space", "--out", "still.png", ...size).status).toBe(0);
    expect(frond("connectedness", "tool=space").stderr).toMatch(/only draws pictures/);
    expect(frond("render", "tool=fit", "--out", "fit.png").stderr).toMatch(/no closed curves/);
  });

  it("writes into each picture the link of its own moment", () => {
    const maps = (...words: string[]) => JSON.parse(frond("export", ...words, "--as", "json").stdout).maps;
    // The link of the first: t = 0.
    expect(frond("render", `${link}&t=0`, "--out", "m.png", "--frames", "3", ...size).status).toBe(0);
    for (const [i, t] of ["0", "0.5", "1"].entries())
      expect(maps(`m-000${i + 1}.png`)).toEqual(maps(link, "--t", t));
    expect(frond("render", `${link}&t=0`, "--out", "m.png", "--t", "0.25", ...size).status).toBe(0);
    expect(maps("m.png")).toEqual(maps(link, "--t", "0.25"));
  });

  it("draws what files hold, as its other commands read them", () => {
    writeFileSync(join(app, "shape.ifs"), GASKET);
    expect(frond("render", "shape.ifs", "--out", "shape.png", ...size)).toMatchObject({ status: 0 });
    expect(sides("shape.png")).toEqual([60, 40]);
    const maps = (file: string) => JSON.parse(frond("export", file, "--as", "json").stdout).maps;
    // The picture holds them again.
    expect(maps("shape.png")).toEqual(maps("shape.ifs"));
    expect(frond("render", "shape.png", "--out", "again.png", ...size).status).toBe(0);
    expect(bytes("again.png").equals(bytes("shape.png"))).toBe(true);
    expect(frond("render", "shape.ifs", "--out", "shape.svg").stderr).toMatch(/in 3 paths/);
    writeFileSync(join(app, "link.txt"), `https://frond.example/#${link}\n`);
    expect(frond("render", "link.txt", "--out", "linked.png", "--t", "0.5", ...size).status).toBe(0);
    expect(frond("render", link, "--out", "own.png", "--t", "0.5", ...size).status).toBe(0);
    expect(pixelsOf(bytes("linked.png"))).toEqual(pixelsOf(bytes("own.png")));
  });

  it("reads the standard input, and writes nothing else to the standard output", () => {
    const words = ["--out", "-", "--as", "png", ...size];
    const piped = given(GASKET, "render", "-", ...words);
    expect([piped.status, piped.stderr]).toEqual([0, "Written: 60 x 40\n"]);
    writeFileSync(join(app, "shape.ifs"), GASKET);
    expect(pixelsOf(piped.bytes)).toEqual(pixelsOf(frond("render", "shape.ifs", ...words).bytes));
    const linked = given(`#${link}\n`, "render", "-", ...words, "--t", "0.5", "--quiet");
    expect([linked.status, linked.stderr, linked.bytes.toString("latin1", 1, 4)]).toEqual([0, "", "PNG"]);
    const rows = frond(
      "locus",
      link,
      "--out",
      "-",
      "--as",
      "csv",
      "--width",
      "3",
      "--height",
      "2",
      "--quiet",
    );
    expect([rows.stderr, rows.stdout.split("\n").length]).toEqual(["", 8]);
    expect(given("", "connectedness", "-")).toMatchObject({
      status: 2,
      stderr: "frond: The standard input is empty.\n",
    });
  });

  it("writes the same bytes, however many workers draw", () => {
    const film = ["--seconds", "0.5", "--fps", "10", ...size];
    const ffmpeg = `[ "$1" = -version ] && exit
      for last; do :; done
      { /usr/bin/cksum; echo "$*" | /usr/bin/sed "s|\${last#file:}||"; } > "\${last#file:}"`;
    for (const kind of ["gif", "apng", "zip", "webm"]) {
      for (const jobs of ["1", "3"])
        expect(
          frondBeside({ ffmpeg }, "render", link, "--out", `${jobs}.${kind}`, "--jobs", jobs, ...film).status,
        ).toBe(0);
      expect(bytes(`3.${kind}`).equals(bytes(`1.${kind}`)), kind).toBe(true);
    }
    expect(bytes("1.webm").toString()).toMatch(
      / -map_metadata -1 -fflags \+bitexact -flags:v \+bitexact -threads 4 .*-f webm /,
    );
  });

  it.skipIf(!python)("writes a ZIP and pictures as Python reads them", () => {
    const film = ["--seconds", "0.3", "--fps", "10", ...size];
    expect(frond("render", link, "--out", "read.zip", ...film).status).toBe(0);
    const program = `
import struct, sys, zipfile, zlib
with zipfile.ZipFile("read.zip") as file:
    print(file.testzip())
    for info in file.infolist():
        data = file.read(info)
        at, packed, sides = 8, b"", None
        while at < len(data):
            length, kind = struct.unpack(">I4s", data[at:at + 8])
            body, check = data[at + 8:at + 8 + length], struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]
            assert zlib.crc32(kind + body) == check
            if kind == b"IHDR": sides = struct.unpack(">II", body[:8])
            if kind == b"IDAT": packed += body
            at += 12 + length
        print(info.filename, info.date_time[0], sides, len(zlib.decompress(packed)))`;
    expect(execFileSync("python3", ["-c", program], { cwd: app }).toString().trim().split("\n")).toEqual([
      "None",
      ...[1, 2, 3].map((i) => `frame-000${i}.png 1980 (60, 40) ${40 * (1 + 4 * 60)}`),
    ]);
  });

  it("draws some of the frames, and leaves those that are there", () => {
    const film = (...words: string[]) =>
      frond("render", link, "--out", "r.png", "--seconds", "0.6", "--fps", "10", ...words, ...size);
    const there = () => readdirSync(app).filter((file) => /^r-\d+\.png$/.test(file));
    expect(film("--frames", "2-4").stderr).toContain("3 frames");
    expect(there()).toEqual(["r-0002.png", "r-0003.png", "r-0004.png"]);
    const [second, third] = [bytes("r-0002.png"), bytes("r-0003.png")];
    // One that is not whole, and one of another moment, are drawn again.
    writeFileSync(join(app, "r-0003.png"), third.subarray(0, third.length - 20));
    writeFileSync(join(app, "r-0004.png"), second);
    const before = statSync(join(app, "r-0002.png")).mtimeMs;
    expect(film("--frames", "1-6", "--resume").stderr).toMatch(/6 frames: 1 were there already/);
    expect(statSync(join(app, "r-0002.png")).mtimeMs).toBe(before);
    expect(bytes("r-0003.png").equals(third)).toBe(true);
    expect(bytes("r-0004.png").equals(second)).toBe(false);
    expect(film("--frames", "1-6", "--resume").stderr).toMatch(/6 were there already/);
    // As the whole film has them.
    expect(frond("render", link, "--out", "w.png", "--frames", "6", ...size).status).toBe(0);
    for (const i of [1, 3, 6]) expect(bytes(`w-000${i}.png`).equals(bytes(`r-000${i}.png`))).toBe(true);
  });

  it("leaves nothing behind that is not whole where it is interrupted", async () => {
    const ffmpeg = `[ "$1" = -version ] && exit
      for last; do :; done
      echo begun > "\${last#file:}"; echo begun >&2; touch begun; exec /bin/sleep 600`;
    for (const [signal, code] of [
      ["SIGINT", 130],
      ["SIGTERM", 143],
    ] as const) {
      const before = readdirSync(app).sort();
      writeFileSync(join(app, "kept.mp4"), "what was there");
      const env = beside({ ffmpeg, touch: 'exec /usr/bin/touch "$@"' });
      const words = ["render", link, "--out", "kept.mp4", "--frames", "3000", ...size];
      const running = spawn(command, words, { cwd: app, env, stdio: ["ignore", "ignore", "pipe"] });
      let said = "";
      running.stderr.on("data", (text) => {
        said += text;
      });
      while (!existsSync(join(app, "begun"))) await new Promise((resolve) => setTimeout(resolve, 20));
      expect(readdirSync(app).some((file) => file.startsWith(".frond-"))).toBe(true);
      running.kill(signal);
      expect(await once(running, "close")).toEqual([code, null]);
      expect(said).toBe("frond: interrupted. What was not whole yet is gone.\n");
      expect(bytes("kept.mp4").toString()).toBe("what was there");
      execFileSync("rm", ["-rf", "begun", "kept.mp4"], { cwd: app });
      const after = readdirSync(app).filter((file) => !file.startsWith("programs-"));
      expect(after.sort()).toEqual(before.filter((file) => !file.startsWith("programs-")));
    }
  });

  it("plans paths, proves them, and proves what shapes are", () => {
    const apart = "a=dragon-3&b=gasket";
    const plan = frond("plan", apart);
    const { points, holds } = JSON.parse(plan.stdout);
    expect([plan.status, holds, points[0], points.at(-1)]).toEqual([0, true, [0, 0], [1, 1]]);
    const planned = frond("plan", apart, "--as", "link").stdout.trim();
    expect(planned).toMatch(/^#.*path=drawn:/);
    const proof = frond("certificate", planned, "--of", "path", "--out", "path.json");
    expect(proof).toMatchObject({ status: 0, stdout: "" });
    expect(frond("check", "path.json")).toMatchObject({
      status: 0,
      stdout: expect.stringMatching(/^No gap wider/),
    });
    // Who claims more than is so is refused.
    const claimed = JSON.parse(bytes("path.json").toString());
    const false_ = JSON.stringify({ ...claimed, proved: { ...claimed.proved, gap: 1e-9 } });
    expect(given(false_, "check", "-")).toMatchObject({
      status: 1,
      stdout: expect.stringMatching(/claimed/),
    });
    // A straight way breaks.
    expect(frond("certificate", link, "--of", "path")).toMatchObject({ status: 1, stdout: "" });
    const piece = frond("certificate", "a=gasket&b=gasket&t=0");
    expect(given(piece.stdout, "check", "-")).toMatchObject({
      status: 0,
      stdout: expect.stringMatching(/links hold/),
    });
    writeFileSync(join(app, "dust.json"), DUST);
    expect(frond("certificate", "dust.json", "--of", "one")).toMatchObject({ status: 1, stdout: "" });
    const several = frond("certificate", "dust.json", "--of", "several");
    expect(given(several.stdout, "check", "-").stdout).toMatch(/apart: checked in exact arithmetic/);
  });

  it("analyzes shapes exactly", () => {
    const koch = frond("analyze", "a=koch&b=gasket&t=0");
    expect(koch.status).toBe(0);
    expect(koch.stdout.split("\n").slice(0, 4)).toEqual([
      "Open set condition: yes, proved.",
      "Neighbours: 4.",
      expect.stringMatching(/^Dimension: log 4 \/ log 3 = 1\.2618595071429\d*, proved\.$/),
      "Inner points: none, proved.",
    ]);
    writeFileSync(join(app, "dust.json"), DUST);
    const dust = frond("analyze", "dust.json", "--json", "--numbers", "3/10, 7/10");
    expect(JSON.parse(dust.stdout)).toMatchObject({ openSetCondition: "yes", numbers: ["3/10", "7/10"] });
    expect(frond("analyze", "dust.json", "--numbers", "1/3,")).toMatchObject({
      status: 2,
      stderr: expect.stringMatching(/--numbers is a list of formulas/),
    });
    expect(frond("analyze", "dust.json", "--numbers", "1/0").stderr).toMatch(/"1\/0" is no exact number/);
  });

  it("traces pictures and fits curves to outlines", () => {
    // A square of 40 pixels in one of 100.
    const mask = greyPng(100, 100, (x, y) => (x >= 30 && x < 70 && y >= 30 && y < 70 ? 0 : 255));
    const traced = given(mask, "trace", "-", "--as", "csv");
    const points = traced.stdout
      .trim()
      .split("\n")
      .slice(1)
      .map((row) => row.split(",").map(Number));
    const [xs, ys] = [points.map(([x = 0]) => x), points.map(([, y = 0]) => y)];
    for (const [list, from, to] of [
      [xs, 30, 70],
      [ys, 30, 70],
    ] as const) {
      expect(Math.min(...list)).toBeCloseTo(from, 0);
      expect(Math.max(...list)).toBeCloseTo(to, 0);
    }
    expect(given(mask, "trace", "-").stdout).toMatch(/^<svg .*viewBox="\d/);
    const square = "x,y\n0,0\n1,0\n1,1\n0,1\n";
    const link = given(square, "fit", "-", "--numbers", "12");
    expect([link.status, link.stdout]).toEqual([0, expect.stringMatching(/^#.*tool=fit/)]);
    const json = JSON.parse(given(square, "fit", "-", "--numbers", "12", "--as", "json").stdout);
    expect([json.kind, json.knots.length >= 3]).toEqual(["closed curve", true]);
    const within = JSON.parse(given(square, "fit", "-", "--bytes", "50", "--as", "json").stdout);
    expect(within.bytes).toBeLessThanOrEqual(50);
    const photograph = join(root, "shared/leaves/leaf_grape_300_scan.jpg");
    if (!existsSync(photograph)) return;
    expect(frond("fit", photograph, "--numbers", "60", "--out", "leaf.svg")).toMatchObject({ status: 0 });
    expect(bytes("leaf.svg").toString()).toMatch(/<path/);
  });

  it("makes meshes of shapes of space", () => {
    const mesh = frond("mesh", "tool=space", "--fineness", "24", "--size", "60", "--out", "s.stl");
    expect(mesh.status).toBe(0);
    // The number stands behind a head of 80 bytes; each triangle takes 50.
    const stl = bytes("s.stl");
    const triangles = stl.readUInt32LE(80);
    expect(stl.length).toBe(84 + 50 * triangles);
    expect(mesh.stderr).toContain(`${triangles} triangles`);
    const corners = Array.from({ length: 9 * triangles }, (_, i) =>
      stl.readFloatLE(84 + 50 * Math.floor(i / 9) + 12 + 4 * (i % 9)),
    );
    const along = [0, 1, 2].map((axis) => {
      const list = corners.filter((_, i) => i % 3 === axis);
      return list.reduce((a, b) => Math.max(a, b)) - list.reduce((a, b) => Math.min(a, b));
    });
    expect(Math.max(...along)).toBeCloseTo(60, 3);
    const glb = frond("mesh", "tool=space", "--fineness", "16", "--out", "-", "--as", "glb");
    expect(glb.bytes.toString("latin1", 0, 4)).toBe("glTF");
  });

  it("says what size a video has become", () => {
    const ffmpeg = `[ "$1" = -version ] && exit
      for last; do :; done
      /bin/cat > "\${last#file:}"`;
    const odd = ["--width", "61", "--height", "40", "--frames", "2", "--out", "odd.mp4"];
    expect(frondBeside({ ffmpeg }, "render", link, ...odd).stderr).toBe(
      "odd.mp4: 62 x 40, 2 frames: a video has even sides, and so a column of the background is added\n",
    );
    const piped = frondBeside(
      { ffmpeg },
      "render",
      link,
      "--out",
      "-",
      "--as",
      "mp4",
      "--frames",
      "2",
      ...size,
    );
    expect([piped.status, piped.bytes.length]).toEqual([0, 2 * 60 * 40 * 4]);
  });

  it("decides, exports and checks", () => {
    expect(frond("locus", link, "--out", "x.csv", "--width", "7", "--height", "7").status).toBe(0);
    const samples = bytes("x.csv")
      .toString()
      .trim()
      .split("\n")
      .slice(1)
      .map((row) => row.split(",").map(Number));
    const place = (i: number) => samples[i]?.slice(0, 2);
    expect(samples.length).toBe(49);
    expect([place(0), place(1), place(7), place(48)]).toEqual([
      [-1, -1],
      [-0.5, -1],
      [-1, -0.5],
      [2, 2],
    ]);
    writeFileSync(join(app, "dust.json"), DUST);
    const decided = frond("connectedness", "dust.json");
    expect([decided.status, JSON.parse(decided.stdout).verdict]).toEqual([1, "disconnected"]);
    expect(frond("certificate", "dust.json", "--out", "proof.json").status).toBe(0);
    expect(frond("check", "proof.json").status).toBe(0);
    const far = frond("distance", "a=gasket&b=gasket");
    expect([far.status, JSON.parse(far.stdout).lower]).toEqual([0, 0]);
    writeFileSync(join(app, "bad.json"), "{}");
    expect(frond("check", "bad.json").status).toBeGreaterThan(0);
  });

  it(
    "says of all that it cannot do what to do, before the work",
    () => {
      const help = frond("--help");
      expect([help.status, help.stdout]).toEqual([0, expect.stringContaining("frond render LINK|FILE|-")]);
      const locus = frond("locus", "--help");
      expect(locus.stdout).toMatch(/^ {2}--bounds -1,2,-1,2 {2}.*\(u|u0,u1,v0,v1/m);
      expect(frond("help", "locus").stdout).toBe(locus.stdout);
      // Each command, with each of its options.
      for (const [, name = ""] of help.stdout.matchAll(/^ {2}frond (\w+) /gm))
        expect(frond("help", name).stdout).toMatch(/^ {2}--quiet /m);
      expect(frond()).toMatchObject({ status: 2, stdout: "", stderr: help.stdout });
      expect(frond("--version")).toMatchObject({ status: 0, stdout: `frond-ifs ${made.manifest.version}\n` });
      const draw = (...words: string[]) => ["render", link, ...words];
      writeFileSync(join(app, "dust.json"), DUST);
      const cases: [words: string[], said: RegExp | string][] = [
        [["dance"], 'There is no command "dance". See frond --help.'],
        [["render"], '"frond render" of what? See frond help render.'],
        [["help", "dance"], 'There is no command "dance". See frond --help.'],
        [["render", "a", "b", "--out", "x.png"], '"b" is one word too many. Put a link into quotes.'],
        [draw(), "Where to? Say --out and the name of a file, or - for the standard output."],
        [draw("--out", "-"), "As what? Say --as and one of png, svg, gif, apng, zip, mp4, webm, mov."],
        [draw("--out", "-", "--as", "bmp"), /^--as is png, svg, .* or mov, and not "bmp"/],
        [draw("--out", "-", "--as", "png", "--frames", "2"), /^Frames are a file each/],
        [draw("--out", "y.gif", "--resume"), /^--resume is of frames that are a file each/],
        [draw("--out", "y.png", "--frames", "0-3"), /counts from 1/],
        [draw("--out", "y.png", "--frames", "5-3"), /ends no earlier than it begins/],
        [draw("--out", "y.png", "--frames", "1-300"), /^This film has no frame 300: it has 200\./],
        [draw("--out", "y.png", "--quiet=yes"), "--quiet has no value after it. See frond --help."],
        [draw("--out", "y.png", "--jobs", "0"), '--jobs is a number from 1 to 256, and not "0".'],
        [draw("--out"), "--out needs a value after it. See frond --help."],
        [draw("--out", "none/x.png"), "There is no folder none: make it first."],
        [draw("--out", "."), ". is a folder: name a file in it."],
        [draw("--out", "x.bmp"), /is to end with \.png, \.svg/],
        [draw("--out", "y.png", "--sise", "3"), "There is no option --sise. See frond --help."],
        [
          draw("--out", "y.png", "--size", "3"),
          '"frond render" has no option --size. See frond help render.',
        ],
        [["check", "x", "--width", "3"], '"frond check" has no option --width. See frond help check.'],
        [draw("--out", "y.png", "--width", "-3"), '--width is a number from 1 to 8192, and not "-3".'],
        [draw("--out", "y.png", "--width", "1e9"), '--width is a number from 1 to 8192, and not "1e9".'],
        [draw("--out", "y.png", "--height", "NaN"), '--height is a number from 1 to 8192, and not "NaN".'],
        [draw("--out", "y.png", "--width", "9.5"), /whole number/],
        [draw("--out", "y.png", "--t", "2"), '--t is a number from 0 to 1, and not "2".'],
        [draw("--out", "y.png", "--background", "red"), "--background is a colour such as #ffffff."],
        [draw("--out", "y.gif", "--frames", "1e7"), /--frames is a number from 1 to 10000/],
        [draw("--out", "y.gif", "--frames", "2", "--seconds", "1"), /not both/],
        [draw("--out", "y.gif", "--hold", "11"), '--hold is a number from 0 to 10, and not "11".'],
        [draw("--out", "y.gif", "--ease", "fast"), '--ease is linear or in-out, and not "fast".'],
        [draw("--out", "y.png", "--hold", "1"), /^One picture has no --hold/],
        [
          [
            "render",
            "a=gasket&b=gasket&tool=deform&mesh=4x4:0,0,1,1&keys=0:;0.5:6,0.2,0",
            "--out",
            "y.gif",
            "--hold",
            "1",
          ],
          "This film has no --hold: its end goes on to its beginning.",
        ],
        [
          draw("--out", "y.gif", "--frames", "9999", "--width", "8192", "--height", "8192"),
          /too large for one file/,
        ],
        [
          ["render", "fern", "--out", "y.png"],
          /^"fern" is neither a file nor a link\. A link looks like "a=fern&b=tree"/,
        ],
        [["render", "dust.json", "--out", "y.gif"], /nothing to film: a file of maps is one shape/],
        [
          ["render", "dust.json", "--out", "y.png", "--t", "0"],
          "A file of maps has no moments: leave --t away.",
        ],
        [["render", "a=%%%", "--out", "y.png"], /^The link cannot be read/],
        [["render", "a=gasket&tool=deform", "--out", "y.gif"], /nothing to film/],
        [["locus", link, "--out", "x.txt"], /is to end with \.csv or \.npy/],
        [
          ["locus", link, "--out", "x.csv", "--width", "1"],
          '--width is a number from 2 to 4096, and not "1".',
        ],
        [["locus", link, "--out", "x.csv", "--bounds", "0,1,1,0"], /^--bounds is u0,u1,v0,v1 with u0 < u1/],
        [["locus", link, "--out", "x.csv", "--bounds", "0,1,0"], /^--bounds is u0,u1,v0,v1/],
        [["locus", link, "--out", "x.csv", "--w", "9"], '--w is a number from -2 to 2, and not "9".'],
        [["locus", link, "--out", "x.csv", "--epsilon", "0"], /^--epsilon is a number/],
        [["locus", "dust.json", "--out", "x.csv"], /holds one shape, and this needs two/],
        [["plan", "dust.json"], /^A path is between two shapes/],
        [["plan", link, "--axes", "4"], '--axes is a number from 2 to 3, and not "4".'],
        [["certificate", link, "--of", "three"], '--of is one, several or path, and not "three".'],
        [["trace", "dust.json", "--threshold", "0.5"], "dust.json is no picture, and has no --threshold."],
        [["trace", "/bin/sh"], /is a program/],
        [["fit", "dust.json", "--numbers", "12", "--bytes", "50"], /not both/],
        [["fit", "dust.json", "--numbers", "3"], /^--numbers is a number from 12 to 2000/],
        [["mesh", link, "--out", "x.stl"], /^A mesh is of a shape of space, and this link is of the plane/],
        [["mesh", "tool=space", "--out", "x.obj"], /is to end with \.stl, \.ply or \.glb/],
        [["mesh", "tool=space", "--out", "x.stl", "--t", "0.5"], /^Nothing moves here/],
        [["connectedness", "none.ifs"], "There is no none.ifs."],
        [["connectedness", "/dev/zero"], /larger than 64 MB/],
        [["connectedness", link, "--epsilon", "no"], /--epsilon is a number/],
        [["check", "index.md"], "There is no index.md."],
        [["export", link, "--as", "word"], /^--as is one of json, /],
      ];
      for (const [words, said] of cases) {
        const { status, stdout, stderr } = frond(...words);
        expect([status, stdout], words.join(" ")).toEqual([2, ""]);
        const problem = stderr.replace(/^frond: /, "").trim();
        if (typeof said === "string") expect(problem).toBe(said);
        else expect(problem, words.join(" ")).toMatch(said);
      }
    },
    SLOW_MS,
  );

  it("hands ffmpeg the frames of a video, where there is one", () => {
    const film = ["render", link, "--out", "x.mp4", "--frames", "3", ...size];
    // It writes what it was told, and how many bytes it was handed.
    const ffmpeg = `[ "$1" = -version ] && exit
      for last; do :; done
      bytes=$(/usr/bin/wc -c)
      echo "$bytes $*" > "\${last#file:}"`;
    expect(frondBeside({ ffmpeg }, ...film)).toMatchObject({ status: 0, stdout: "" });
    const said = bytes("x.mp4").toString();
    expect(Number.parseInt(said, 10)).toBe(3 * 60 * 40 * 4);
    expect(said).toContain("-f rawvideo -pix_fmt rgba -s 60x40 -r 25 -i -");
    expect(said).toMatch(/out_color_matrix=bt709.*:colorspace=bt709.* -pix_fmt yuv420p /);
    const full = '[ "$1" = -version ] && exit; echo "x.mp4: No space left on device" >&2; exit 1';
    const failed = frondBeside({ ffmpeg: full }, ...film);
    expect(failed.status).toBe(2);
    expect(failed.stderr).toContain("ffmpeg could not make x.mp4: x.mp4: No space left on device");
  });

  it("tells how a video is made, in words that a shell reads as they are meant", () => {
    const film = ["render", "a=fern&b='$(id)'", "--out", "my film.mp4", "--seconds", "2"];
    const { status, stderr } = frondBeside({}, ...film);
    expect(status).toBe(2);
    const [, draws = "", encodes = ""] = stderr.split("\n");
    const words = (line: string) =>
      execFileSync("sh", ["-c", `set -- ${line}; printf '%s\\n' "$@"`])
        .toString()
        .trim()
        .split("\n");
    expect(words(draws)).toEqual([
      "frond",
      "render",
      "a=fern&b='$(id)'",
      "--out",
      "my film.png",
      "--frames",
      "50",
      "--background",
      "#ffffff",
    ]);
    expect(words(encodes)).toEqual([
      "ffmpeg",
      "-framerate",
      "25",
      "-i",
      "my film-%04d.png",
      "-pix_fmt",
      "yuv420p",
      "my film.mp4",
    ]);
  });
});

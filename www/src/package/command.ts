/** The command `frond`: pictures, films, loci and answers without a browser. What the system gives is handed in. */
import { type Box, boxAt, calmTrack } from "#geometry/boxes";
import { pointsOf, uvAt } from "#geometry/path";
import { palette } from "#style/palette";
import type { ExportFormat, Ifs, Locus, PathPlan, Scene } from "#wasm/api";
import { type ApngFrame, apngBytes } from "#workers/film/format/apng";
import { gifSink, MOST_GIF_FPS } from "#workers/film/format/gif";
import { PngFile } from "#workers/film/format/png-file";
import { frameName } from "#workers/film/format/zip";
import { layOn } from "#workers/film/opaque";
import { inOrder } from "#workers/film/order";
import { chunksOf } from "#workers/image/png";

type Draw = typeof import("../../pkg/frond.js");
type Proof = typeof import("../../pkg/frond-proof.js");
type Exchange = typeof import("../../pkg/frond-exchange.js");
type Pixels = Uint8ClampedArray<ArrayBuffer>;

interface Pool {
  size: number;
  rasterize(ifs: Ifs, options: Parameters<Draw["rasterize"]>[1]): Promise<Pixels>;
  planPath(...args: Parameters<Proof["planPath"]>): Promise<PathPlan>;
  connectedness(...args: Parameters<Proof["connectedness"]>): Promise<ReturnType<Proof["connectedness"]>>;
  locus(...args: [...Parameters<Proof["locus"]>, { onProgress(share: number): void }]): Promise<Locus>;
}

export interface System {
  draw(): Promise<Draw>;
  proof(): Promise<Proof>;
  exchange(): Promise<Exchange>;
  pool(): Pool;
  read(file: string): Promise<Uint8Array>;
  write(file: string, bytes: Uint8Array | string): Promise<void>;
  print(line: string): void;
  /** What is said while it works, and is no answer. */
  tell(line: string): void;
}

export type Options = Partial<Record<string, string | boolean>>;

/** What is asked for cannot be done: the command says why, and nothing else. */
export class Refusal extends Error {}

export const HELP = `frond: the studio without a browser

  frond render <link> --out x.png|gif|apng|zip    a picture, or a film of the morph
    --width 1200 --height 900 --t 0.5              of one moment; without --t that of the link
    --seconds 8 --fps 25                           of a film; a ZIP holds its frames as PNG
    --background #ffffff                           otherwise clear
  frond locus <link> --out x.csv|npy               verdict and gap of every sample of (u, v)
    --width 301 --height 301
  frond connectedness <link|file> [--t 0.5] [--epsilon 0.0001]
  frond check <certificate.json>                   replays a proof that a shape is in pieces
  frond export <link|file> --as FORMAT [--out file] [--t 0.5]

A link is one of the studio, or what stands behind its #: "a=fern&b=tree". A file holds maps: .ifs, .flame, .aifs, JSON,
a table, or a PNG of Frond's. Exit codes: 0 done, 1 the answer is no, 2 it could not be done.`;

const MOST_SIDE = 8192;
const MOST_FRAMES = 10_000;
/** How often the way is looked at for where the camera goes. */
const LOOKS = 13;
/** Free on each side, as a part of the shorter one. */
const MARGIN = 0.06;

/** Resolves to the exit code. */
export async function run(words: string[], options: Options, system: System): Promise<number> {
  const [command = "", subject] = words;
  const commands: Record<string, (subject: string, options: Options, system: System) => Promise<number>> = {
    render,
    locus,
    connectedness,
    check,
    export: exported,
  };
  if (options["help"] || command === "" || command === "help") {
    system.print(HELP);
    return 0;
  }
  const chosen = Object.hasOwn(commands, command) ? commands[command] : undefined;
  if (!chosen) throw new Refusal(`There is no command "${command}". See frond --help.`);
  if (!subject) throw new Refusal(`"frond ${command}" of what? See frond --help.`);
  if (words.length > 2) throw new Refusal(`"${words[2]}" is one word too many. Put a link into quotes.`);
  return chosen(subject, options, system);
}

function number(options: Options, name: string, least: number, most: number, otherwise: number): number {
  const text = options[name];
  if (text === undefined) return otherwise;
  const value = Number(text);
  if (text === "" || !(value >= least && value <= most))
    throw new Refusal(`--${name} is a number from ${least} to ${most}, and not "${text}".`);
  return value;
}

const whole = (...args: Parameters<typeof number>) => Math.round(number(...args));

/** A morph as a link says it, and how to get on its way. */
async function morphOf(link: string, system: System) {
  const draw = await system.draw();
  const fragment = link.slice(link.indexOf("#") + 1);
  if (!fragment.includes("=")) throw new Refusal(`"${link}" is no link. One looks like "a=fern&b=tree".`);
  const { scene, problem } = draw.decodeScene(fragment);
  if (problem) throw new Refusal(`The link cannot be read: ${problem.message}`);
  const other = (scene.tool ?? "morph") !== "morph" || scene.curves || scene.deform;
  if (other)
    throw new Refusal("The command knows morphs only. Save what Deform, Fit and Space show in the studio.");
  const { from, to } = draw.pair({ maps: scene.a.maps }, { maps: scene.b.maps });
  const fitting = <T>(list: T[]) => (list.length === from.length ? list : []);
  const morph = {
    mode: scene.mode,
    ...(fitting(scene.correspondence).length > 0 ? { correspondence: scene.correspondence } : {}),
    ...(fitting(scene.turns).length > 0 ? { turns: scene.turns } : {}),
  };
  const ends: [Ifs, Ifs] = [{ maps: from }, { maps: to }];
  const planned = async (): Promise<Scene["path"]> => {
    const { path } = scene;
    if (path.kind !== "auto" || path.points.length > 0) return path;
    const { points } = await system.pool().planPath(...ends, morph);
    return { ...path, points: points.slice(1, -1) };
  };
  const at = async (moments: number[]): Promise<Ifs[]> => {
    const inside = moments.some((t) => t > 0 && t < 1);
    const points = pointsOf(inside ? await planned() : scene.path);
    return moments.map((t) => {
      const [u, v, w = 0] = uvAt(points, t);
      return draw.interpolate(...ends, { ...morph, u, v, w });
    });
  };
  return { draw, scene, ends, morph, at };
}

function boxOf(draw: Draw, ifs: Ifs): Box | null {
  try {
    const { min, max } = draw.bounds(ifs);
    const [[x0, y0], [x1, y1]] = [min, max];
    return { x0, y0, x1, y1 };
  } catch {
    return null;
  }
}

async function render(link: string, options: Options, system: System): Promise<number> {
  const out = outOf(options);
  const kind = endOf(out);
  if (kind === "mp4" || kind === "webm")
    throw new Refusal(
      "Node encodes no video. Write frames with --out frames.zip and give them to ffmpeg, or write .gif or .apng.",
    );
  if (kind === "svg")
    throw new Refusal(
      "For a drawing: frond export <link> --as svg --out x.svg. Here are .png, .gif, .apng and .zip.",
    );
  if (!["png", "gif", "apng", "zip"].includes(kind))
    throw new Refusal(`"${out}" is to end with .png, .gif, .apng or .zip.`);
  const size = {
    width: whole(options, "width", 1, MOST_SIDE, 1200),
    height: whole(options, "height", 1, MOST_SIDE, 900),
  };
  const ground = groundOf(options);
  const { draw, scene, at } = await morphOf(link, system);
  const fps = number(options, "fps", 1, kind === "gif" ? MOST_GIF_FPS : 120, 25);
  const seconds = number(options, "seconds", 1 / fps, MOST_FRAMES / fps, 8);
  const count = kind === "png" ? 1 : Math.max(1, Math.round(seconds * fps));
  const moment = (i: number) =>
    kind === "png" ? number(options, "t", 0, 1, scene.t) : count === 1 ? 0 : i / (count - 1);
  const looks = (await at(Array.from({ length: LOOKS }, (_, i) => i / (LOOKS - 1)))).map((ifs) =>
    boxOf(draw, ifs),
  );
  const track = calmTrack(looks);
  const systems = await at(Array.from({ length: count }, (_, i) => moment(i)));
  const pool = system.pool();
  const colours = palette(ground !== null && dark(ground) ? "dark" : "light");
  const drawn = async (i: number): Promise<Pixels> => {
    const ifs = systems[i] ?? { maps: [] };
    const box = kind === "png" ? (boxOf(draw, ifs) ?? boxAt(track, 0)) : boxAt(track, moment(i));
    const view = viewOf(box, size);
    const style = { colouring: scene.colouring, palette: colours };
    const pixels = await pool.rasterize(ifs, { ...size, view, ...style });
    if (ground !== null) layOn(pixels, ground);
    return pixels;
  };
  const still = async (pixels: Pixels, address: string | null = null) => {
    const file = new PngFile({ ...size, opaque: ground !== null, link: address });
    await file.add(pixels);
    return file.finish();
  };
  const frames = (take: (i: number, pixels: Pixels) => Promise<void>) =>
    inOrder(count, 2 * pool.size, drawn, async (i, pixels) => {
      await take(i, pixels);
      if ((i + 1) % 25 === 0) system.tell(`${i + 1} of ${count} frames`);
    });
  if (kind === "png") {
    const address = link.includes("#") ? link : `#${link}`;
    await system.write(out, await still(await drawn(0), address));
  } else if (kind === "gif") {
    const first = await drawn(Math.floor(count / 2));
    const sink = await gifSink({ ...size, fps, ground, dither: false, samples: first });
    await frames((_, pixels) => sink.add(pixels));
    await system.write(out, await sink.finish());
  } else if (kind === "apng") {
    const made: ApngFrame[] = [];
    let head: Uint8Array | null = null;
    await frames(async (_, pixels) => {
      const chunks = chunksOf(await still(pixels));
      head ??= chunks.find(({ type }) => type === "IHDR")?.data ?? null;
      made.push({ data: chunks.filter(({ type }) => type === "IDAT").map(({ data }) => data), count: 1 });
    });
    if (head) await system.write(out, apngBytes(head, made, { ...size, fps }));
  } else {
    const { zipSync } = await import("fflate");
    const files: Record<string, Uint8Array> = {};
    await frames(async (i, pixels) => {
      files[frameName(i + 1)] = await still(pixels);
    });
    // Pictures are packed already.
    await system.write(out, zipSync(files, { level: 0 }));
  }
  system.tell(`${out}: ${size.width} x ${size.height}${kind === "png" ? "" : `, ${count} frames`}`);
  return 0;
}

async function locus(link: string, options: Options, system: System): Promise<number> {
  const out = outOf(options);
  const kind = endOf(out);
  if (kind !== "csv" && kind !== "npy")
    throw new Refusal(`"${out}" is to end with .csv or .npy. The map as a picture is saved in the studio.`);
  const { ends, morph } = await morphOf(link, system);
  const size = {
    width: whole(options, "width", 2, 4096, 301),
    height: whole(options, "height", 2, 4096, 301),
  };
  const bounds = { u0: -1, v0: -1, u1: 2, v1: 2 };
  let told = 0;
  const onProgress = (share: number) => {
    if (share - told < 0.1) return;
    told = share;
    system.tell(`${Math.round(100 * share)} %`);
  };
  const { state, gap } = await system.pool().locus(...ends, { ...morph, ...size, bounds }, { onProgress });
  const { locusCsv, locusNpy } = await system.exchange();
  const corners = [bounds.u0, bounds.v0, bounds.u1, bounds.v1];
  await system.write(out, (kind === "csv" ? locusCsv : locusNpy)(corners, size.width, state, gap));
  return 0;
}

/** Maps of a file, or of a link at a moment. */
async function mapsOf(subject: string, options: Options, system: System): Promise<Ifs & { name: string }> {
  let link = subject;
  if (!subject.includes("=") || /^[./]/.test(subject)) {
    const { importFile } = await system.exchange();
    const { systems, link: inside } = importFile(await system.read(subject));
    const [first] = systems;
    if (first) {
      if (systems.length > 1) system.tell(`The first of ${systems.length} systems: ${first.name}`);
      if (first.maps.some((map) => map.length !== 6)) throw new Refusal("These are maps of space.");
      return { name: first.name, maps: first.maps as Ifs["maps"] };
    }
    if (inside === undefined) throw new Refusal(`There are no maps in ${subject}.`);
    link = inside;
  }
  const { scene, at } = await morphOf(link, system);
  const [ifs] = await at([number(options, "t", 0, 1, scene.t)]);
  return { maps: ifs?.maps ?? [], name: `${scene.a.name} to ${scene.b.name}` };
}

async function connectedness(subject: string, options: Options, system: System): Promise<number> {
  const epsilon = number(options, "epsilon", 1e-12, 1, 1 / 600);
  const found = await system.pool().connectedness(await mapsOf(subject, options, system), { epsilon });
  system.print(JSON.stringify(found, null, 2));
  return found.verdict === "connected" || found.verdict === "touching" ? 0 : 1;
}

async function check(file: string, _: Options, system: System): Promise<number> {
  const { checkCertificate } = await system.proof();
  const { valid, text } = checkCertificate(parsed(file, await system.read(file)));
  system.print(text);
  return valid ? 0 : 1;
}

async function exported(subject: string, options: Options, system: System): Promise<number> {
  const { exportFormats, exportMaps } = await system.exchange();
  const formats = exportFormats().map(({ id }) => id);
  const format = String(options["as"] ?? "") as ExportFormat;
  if (!formats.includes(format)) throw new Refusal(`--as is one of ${formats.join(", ")}.`);
  const text = exportMaps(await mapsOf(subject, options, system), format);
  if (options["out"]) await system.write(outOf(options), text);
  else system.print(text);
  return 0;
}

function parsed(file: string, bytes: Uint8Array) {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    throw new Refusal(`${file} is no JSON.`);
  }
}

function outOf(options: Options): string {
  const out = options["out"];
  if (typeof out !== "string" || out === "") throw new Refusal("Where to? Say --out and the name of a file.");
  return out;
}

const endOf = (file: string) => /\.([a-z0-9]+)$/i.exec(file)?.[1]?.toLowerCase() ?? "";

function groundOf(options: Options): string | null {
  const ground = options["background"];
  if (ground === undefined) return null;
  if (!/^#[0-9a-f]{6}$/i.test(String(ground))) throw new Refusal("--background is a colour such as #ffffff.");
  return String(ground);
}

function dark(ground: string): boolean {
  const value = Number.parseInt(ground.slice(1), 16);
  return (value >> 16) + ((value >> 8) & 255) + (value & 255) < 384;
}

function viewOf({ x0, y0, x1, y1 }: Box, { width, height }: { width: number; height: number }) {
  const edge = 2 * MARGIN * Math.min(width, height);
  const across = (width - edge) / (x1 - x0);
  const up = (height - edge) / (y1 - y0);
  const scale = Math.min(...[across, up].filter((value) => Number.isFinite(value) && value > 0), 1e9);
  return { x: (x0 + x1) / 2, y: (y0 + y1) / 2, scale };
}

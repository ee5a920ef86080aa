/** Pictures and films of what a link shows. */
import { type Easing, heldFrames, MOST_HOLD, momentsOf } from "#geometry/pace";
import { WHITE } from "#style/colours";
import { type ApngFrame, apngBytes } from "#workers/film/format/apng";
import { gifSink, MOST_GIF_FPS } from "#workers/film/format/gif";
import { PngFile } from "#workers/film/format/png-file";
import { frameName } from "#workers/film/format/zip";
import { layOn } from "#workers/film/opaque";
import { inOrder } from "#workers/film/order";
import { chunksOf } from "#workers/image/png";
import { opened } from "./morph";
import { endOf, groundOf, number, type Options, outOf, Refusal, whole } from "./options";
import { type Look, type Shown, shownOf } from "./shown";
import type { Pixels, System } from "./system";

const MOST_SIDE = 8192;
const MOST_FRAMES = 10_000;
/** Bytes of pictures that may be under way at a time. */
const MOST_UNDER_WAY = 1 << 29;
/** Pixels of all frames of a film that is held until it is whole: what is written frame by frame may be larger. */
const MOST_HELD = 2 ** 32;

/** A film in the making. */
interface Film {
  options: Options;
  out: string;
  link: string;
  look: Look;
  fps: number;
  count: number;
  /** Frame i, complete. */
  drawn(i: number): Promise<Pixels>;
  /** All frames, in their order. */
  each(take: (i: number, pixels: Pixels) => Promise<void>): Promise<void>;
  /** A PNG. */
  still(pixels: Pixels, link?: string | null): Promise<Uint8Array>;
  system: System;
}

type Write = (film: Film) => Promise<void>;
const WRITERS: Readonly<Record<string, Write>> = { png, gif, apng, zip, mp4: video, webm: video, mov: video };

export async function render(link: string, options: Options, system: System): Promise<number> {
  const out = outOf(options);
  const kind = endOf(out);
  const write = Object.hasOwn(WRITERS, kind) ? WRITERS[kind] : undefined;
  if (!write && kind !== "svg")
    throw new Refusal(`"${out}" is to end with .png, .svg, .gif, .apng, .zip, .mp4 or .webm.`);
  if (write === video && !(await system.encodes())) throw new Refusal(byFfmpeg(link, out, options));
  const size = {
    width: whole(options, "width", 1, MOST_SIDE, 1200),
    height: whole(options, "height", 1, MOST_SIDE, 900),
  };
  // A video cannot be clear.
  const look = { ...size, ground: groundOf(options) ?? (write === video ? WHITE : null) };
  const film = kind !== "svg" && (kind !== "png" || options["frames"] !== undefined);
  const foreign = film
    ? ["t"]
    : ["seconds", "fps", "frames", "ease", "hold", ...(write ? [] : ["width", "height", "background"])];
  const misplaced = foreign.find((name) => options[name] !== undefined);
  if (misplaced)
    throw new Refusal(
      film
        ? "A film has no --t: it shows the whole way."
        : `${write ? "One picture" : "A drawing in SVG"} has no --${misplaced}. A film ends with .gif, .apng, .zip, .mp4 or .webm.`,
    );
  const shown = await shownOf(await opened(link, system), system);
  const t = number(options, "t", 0, 1, shown.t);
  if (!write) return drawing(shown, t, out, system);
  const fps = number(options, "fps", 1, kind === "gif" ? MOST_GIF_FPS : 120, 25);
  const moving = film ? framesOf(options, fps, shown) : 1;
  const repeat = shown.round ? "round" : "once";
  const pace = { easing: easingOf(options, shown), held: heldOf(options, fps, shown) };
  const count = moving + 2 * pace.held;
  if (count > MOST_FRAMES)
    throw new Refusal(`${count} frames are too many: ${MOST_FRAMES} is the most. Say a smaller --hold.`);
  if (film && kind !== "png" && write !== video && count * look.width * look.height > MOST_HELD)
    throw new Refusal(
      "This film is too large for one file: write frames with --frames and .png, or a smaller one.",
    );
  const moments = film ? momentsOf({ from: 0, to: 1 }, moving, repeat, pace) : [t];
  const paint = await shown.frames(moments, look);
  const drawn = async (i: number): Promise<Pixels> => {
    const pixels = await paint(i);
    if (look.ground !== null) layOn(pixels, look.ground);
    return pixels;
  };
  const pool = system.pool();
  const room = Math.floor(MOST_UNDER_WAY / (4 * look.width * look.height));
  await write({
    options,
    out,
    link: link.includes("#") ? link : `#${link}`,
    look,
    fps,
    count,
    drawn,
    each: (take) =>
      inOrder(count, Math.max(1, Math.min(2 * pool.size, room)), drawn, async (i, pixels) => {
        await take(i, pixels);
        if ((i + 1) % 25 === 0) system.tell(`${i + 1} of ${count} frames`);
      }),
    async still(pixels, address = null) {
      const file = new PngFile({ ...size, opaque: look.ground !== null, link: address });
      await file.add(pixels);
      return file.finish();
    },
    system,
  });
  const frames = count === 1 ? "1 frame" : `${count} frames`;
  system.tell(`${out}: ${look.width} x ${look.height}${film ? `, ${frames}` : ""}`);
  return 0;
}

function framesOf(options: Options, fps: number, { still, seconds: usual }: Shown): number {
  if (still) throw new Refusal(`There is nothing to film: ${still}. For a picture say --out x.png.`);
  if (options["frames"] !== undefined) {
    if (options["seconds"] !== undefined) throw new Refusal("Say --frames or --seconds, and not both.");
    return whole(options, "frames", 1, MOST_FRAMES, 1);
  }
  const seconds = number(options, "seconds", 1 / fps, MOST_FRAMES / fps, usual);
  return Math.min(MOST_FRAMES, Math.max(1, Math.round(seconds * fps)));
}

const NO_ENDS = "its end goes on to its beginning";

/** --ease: whether it starts and stops gently. */
function easingOf({ ease }: Options, { round }: Shown): Easing {
  if (ease === undefined || ease === "linear") return "linear";
  if (ease !== "in-out") throw new Refusal(`--ease is linear or in-out, and not "${ease}".`);
  if (round) throw new Refusal(`This film has no --ease: ${NO_ENDS}.`);
  return "ease";
}

/** --hold: frames that stand still at each end. */
function heldOf(options: Options, fps: number, { round }: Shown): number {
  const hold = number(options, "hold", 0, MOST_HOLD, 0);
  if (round && hold > 0) throw new Refusal(`This film has no --hold: ${NO_ENDS}.`);
  return heldFrames(hold, fps, round ? "round" : "once");
}

/** As a shell reads it back, whatever is in it. */
const quoted = (text: string) => `'${text.replaceAll("'", "'\\''")}'`;

/** What makes a video of frames: Node has no encoder. */
function byFfmpeg(link: string, out: string, options: Options): string {
  const name = out.replace(/\.[a-z0-9]+$/i, "");
  const fps = options["fps"] ?? 25;
  const frames = options["frames"] ?? Math.max(1, Math.round(Number(options["seconds"] ?? 8) * Number(fps)));
  const ground = String(options["background"] ?? WHITE);
  const pace = (["ease", "hold"] as const)
    .filter((name) => options[name] !== undefined)
    .map((name) => ` --${name} ${quoted(String(options[name]))}`)
    .join("");
  return [
    "Node encodes no video. Install ffmpeg, which Frond then uses, or have it make one of frames elsewhere:",
    `  frond render ${quoted(link)} --out ${quoted(`${name}.png`)} --frames ${frames} --background ${quoted(ground)}${pace}`,
    `  ffmpeg -framerate ${fps} -i ${quoted(`${name}-%04d.png`)} -pix_fmt yuv420p ${quoted(out)}`,
    "Or write .gif or .apng. The studio, too, saves MP4 and WebM.",
  ].join("\n");
}

async function drawing({ plain }: Shown, t: number, out: string, system: System): Promise<number> {
  if (!plain)
    throw new Refusal("Only a shape of the plane that nothing bends can be had as SVG. Write .png.");
  const { exportMaps } = await system.exchange();
  const text = exportMaps(await plain(t), "svg");
  await system.write(out, text);
  system.tell(`${out}: ${/<desc>(.*?)\. /.exec(text)?.[1] ?? ""}`);
  return 0;
}

async function png({ options, out, link, drawn, each, still, system }: Film) {
  if (options["frames"] === undefined) return system.write(out, await still(await drawn(0), link));
  const name = (i: number) => out.replace(/(?=\.[a-z]+$)/i, `-${String(i + 1).padStart(4, "0")}`);
  return each(async (i, pixels) => system.write(name(i), await still(pixels)));
}

async function gif({ out, look, fps, count, drawn, each, system }: Film) {
  const { width, height, ground } = look;
  const samples = await drawn(Math.floor(count / 2));
  const sink = await gifSink({ width, height, fps, ground, dither: false, samples });
  await each((_, pixels) => sink.add(pixels));
  await system.write(out, await sink.finish());
}

async function apng({ out, look, fps, each, still, system }: Film) {
  const made: ApngFrame[] = [];
  let head: Uint8Array | null = null;
  await each(async (_, pixels) => {
    const chunks = chunksOf(await still(pixels));
    head ??= chunks.find(({ type }) => type === "IHDR")?.data ?? null;
    made.push({ data: chunks.filter(({ type }) => type === "IDAT").map(({ data }) => data), count: 1 });
  });
  if (head) await system.write(out, apngBytes(head, made, { width: look.width, height: look.height, fps }));
}

async function video({ out, look, fps, each, system }: Film) {
  const { width, height, ground } = look;
  const encoder = await system.encoder(out, { width, height, fps, ground: ground ?? WHITE });
  await each((_, pixels) => encoder.add(pixels));
  await encoder.finish();
}

async function zip({ out, each, still, system }: Film) {
  const { zipSync } = await import("fflate");
  const files: Record<string, Uint8Array> = {};
  await each(async (i, pixels) => {
    files[frameName(i + 1)] = await still(pixels);
  });
  // Pictures are packed already.
  await system.write(out, zipSync(files, { level: 0 }));
}

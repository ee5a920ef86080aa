/** Pictures and films of what a link or a file shows. */
import { type Easing, heldFrames, MOST_HOLD, momentsOf } from "#geometry/pace";
import { WHITE } from "#style/colours";
import { MOST_GIF_FPS } from "#workers/film/format/gif";
import { groundOf, kindOf, number, type Options, outOf, Refusal, STANDARD, whole } from "../options";
import { noMoments, type Subject, subjectOf } from "../subject";
import type { System } from "../system";
import { apng, type Film, gif, png, video, type Written, zip } from "./film";
import { type Shown, shownOf } from "./shown";

const MOST_SIDE = 8192;
const MOST_FRAMES = 10_000;
const MOST_JOBS = 256;
/** Pixels of all frames of a film that is held until it is whole: what is written frame by frame may be larger. */
const MOST_HELD = 2 ** 32;

const WRITERS = {
  png,
  gif,
  apng,
  zip,
  mp4: video("mp4"),
  webm: video("webm"),
  mov: video("mov"),
} as const satisfies Record<string, (film: Film) => Promise<Written>>;
const KINDS = ["png", "svg", "gif", "apng", "zip", "mp4", "webm", "mov"] as const;
const VIDEOS: readonly string[] = ["mp4", "webm", "mov"];

export async function render(word: string, options: Options, system: System): Promise<number> {
  const out = outOf(options);
  const kind = kindOf(options, KINDS);
  const isVideo = VIDEOS.includes(kind);
  if (isVideo && !(await system.encodes())) throw new Refusal(byFfmpeg(word, out, options));
  const size = {
    width: whole(options, "width", 1, MOST_SIDE, 1200),
    height: whole(options, "height", 1, MOST_SIDE, 900),
  };
  // A video cannot be clear.
  const look = { ...size, ground: groundOf(options) ?? (isVideo ? WHITE : null) };
  const film = kind !== "svg" && (kind !== "png" || options["frames"] !== undefined);
  const misplaced = foreignTo(kind, film).find((name) => options[name] !== undefined);
  if (misplaced) throw new Refusal(whyMisplaced(misplaced, kind, film));
  if (film && kind === "png" && out === STANDARD)
    throw new Refusal("Frames are a file each: say --out and a name, as x.png.");
  if (options["jobs"] !== undefined) system.pool(whole(options, "jobs", 1, MOST_JOBS, 1));
  const subject = await subjectOf(word, system);
  noMoments(subject, options);
  const shown = await shownOf(subject, system);
  const t = number(options, "t", 0, 1, shown.t);
  if (kind === "svg") return drawing(shown, t, out, system);
  const fps = number(options, "fps", 1, kind === "gif" ? MOST_GIF_FPS : 120, 25);
  const { moments, frames } = film ? filmed(options, fps, shown) : { moments: [t], frames: null };
  const pixels = (frames?.length ?? 1) * look.width * look.height;
  if (film && kind !== "png" && !isVideo && pixels > MOST_HELD)
    throw new Refusal(
      "This film is too large for one file: write frames with --frames and .png, or a smaller one.",
    );
  const draw = await system.draw();
  const drawn = await shown.frames(moments, look);
  const written = await WRITERS[kind]({
    out,
    look,
    fps,
    frames,
    resume: options["resume"] === true,
    frame: (i) => ({ drawing: drawn(i), ...look }),
    link: (i) => linkAt(subject, shown, moments[i] ?? t, draw.encodeScene),
    system,
  });
  const count = frames === null ? "" : frames.length === 1 ? ", 1 frame" : `, ${frames.length} frames`;
  const remark = written.remark ? `: ${written.remark}` : "";
  system.tell(`${told(out)}: ${written.width} x ${written.height}${count}${remark}`);
  return 0;
}

/** The link that opens what a moment shows; as it came where it shows that already. */
function linkAt(
  { page, link, scene }: Subject,
  shown: Shown,
  moment: number,
  encode: (s: Subject["scene"]) => string,
) {
  if (link !== null && moment === shown.t) return link;
  return `${page}#${encode(moment === shown.t ? scene : shown.at(moment))}`;
}

/** What cannot be said of this kind of file. */
function foreignTo(kind: (typeof KINDS)[number], film: boolean): string[] {
  const ofFilms = ["seconds", "fps", "frames", "ease", "hold", "resume"];
  if (film) return ["t", ...(kind === "png" ? [] : ["resume"])];
  return [...ofFilms, ...(kind === "svg" ? ["width", "height", "background"] : [])];
}

function whyMisplaced(name: string, kind: (typeof KINDS)[number], film: boolean): string {
  if (name === "resume" && film)
    return "--resume is of frames that are a file each: say --out x.png, with --frames.";
  if (film) return "A film has no --t: it shows the whole way.";
  const what = kind === "svg" ? "A drawing in SVG" : "One picture";
  return `${what} has no --${name}. A film ends with .gif, .apng, .zip, .mp4 or .webm.`;
}

/** What a file is called when it is told of. */
const told = (out: string) => (out === STANDARD ? "Written" : out);

/** The moments of all frames, and which of the frames are wanted, from 0. */
function filmed(options: Options, fps: number, shown: Shown): { moments: number[]; frames: number[] } {
  const range = rangeOf(options);
  const moving = movingOf(options, fps, shown, range !== null);
  const repeat = shown.round ? "round" : "once";
  const pace = { easing: easingOf(options, shown), held: heldOf(options, fps, shown) };
  const count = moving + 2 * pace.held;
  if (count > MOST_FRAMES)
    throw new Refusal(`${count} frames are too many: ${MOST_FRAMES} is the most. Say a smaller --hold.`);
  const [first, last] = range ?? [1, count];
  if (last > count)
    throw new Refusal(
      `This film has no frame ${last}: it has ${count}. Say more --seconds, or a larger --fps.`,
    );
  return {
    moments: momentsOf({ from: 0, to: 1 }, moving, repeat, pace),
    frames: Array.from({ length: last - first + 1 }, (_, k) => first - 1 + k),
  };
}

/** --frames 1-100: the first and the last, from 1. */
function rangeOf({ frames }: Options): [first: number, last: number] | null {
  const found = /^(\d{1,6})-(\d{1,6})$/.exec(String(frames ?? ""));
  if (!found) return null;
  const [first, last] = [Number(found[1]), Number(found[2])];
  if (first < 1 || last < first)
    throw new Refusal(
      `--frames counts from 1, as 1-100, and ends no earlier than it begins: not "${frames}".`,
    );
  return [first, last];
}

function movingOf(options: Options, fps: number, { still, seconds: usual }: Shown, range: boolean): number {
  if (still) throw new Refusal(`There is nothing to film: ${still}. For a picture say --out x.png.`);
  if (options["frames"] !== undefined && !range) {
    if (options["seconds"] !== undefined)
      throw new Refusal("Say --frames or --seconds, and not both; or some of the frames, as --frames 1-100.");
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
  const name = out === STANDARD ? "film" : out.replace(/\.[a-z0-9]+$/i, "");
  const fps = options["fps"] ?? 25;
  const frames = options["frames"] ?? Math.max(1, Math.round(Number(options["seconds"] ?? 8) * Number(fps)));
  const ground = String(options["background"] ?? WHITE);
  const pace = (["ease", "hold"] as const)
    .filter((name) => options[name] !== undefined)
    .map((name) => ` --${name} ${quoted(String(options[name]))}`)
    .join("");
  const made = out === STANDARD ? `${name}.${String(options["as"])}` : out;
  return [
    "Node encodes no video. Install ffmpeg, which Frond then uses, or have it make one of frames elsewhere:",
    `  frond render ${quoted(link)} --out ${quoted(`${name}.png`)} --frames ${frames} --background ${quoted(ground)}${pace}`,
    `  ffmpeg -framerate ${fps} -i ${quoted(`${name}-%04d.png`)} -pix_fmt yuv420p ${quoted(made)}`,
    "Or write .gif or .apng. The studio, too, saves MP4 and WebM.",
  ].join("\n");
}

async function drawing({ plain }: Shown, t: number, out: string, system: System): Promise<number> {
  if (!plain)
    throw new Refusal("Only a shape of the plane that nothing bends can be had as SVG. Write .png.");
  const { exportMaps } = await system.exchange();
  const text = exportMaps(await plain(t), "svg");
  await system.write(out, text);
  system.tell(`${told(out)}: ${/<desc>(.*?)\. /.exec(text)?.[1] ?? ""}`);
  return 0;
}

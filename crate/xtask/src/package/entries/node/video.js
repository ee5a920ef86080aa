// Videos are encoded by ffmpeg, where it is installed.
import { execFile, spawn } from "node:child_process";
import { once } from "node:events";
import { createReadStream } from "node:fs";
import { placeApart, placeFor, print, STANDARD } from "./output.js";

/** Encoders split their work by threads, and write other bytes with others: so many, whatever the machine has. */
const THREADS = 4;
const running = new Set();

/** For the end of the program. */
export function stopEncoders() {
  for (const ffmpeg of running) ffmpeg.kill("SIGKILL");
}

export const encodes = () =>
  new Promise((resolve) => execFile("ffmpeg", ["-version"], (problem) => resolve(problem === null)));

function wordsFor(path, { kind, width, height, fps, ground }) {
  const raw = ["-f", "rawvideo", "-pix_fmt", "rgba", "-s", `${width}x${height}`, "-r", `${fps}`, "-i", "-"];
  const even = `pad=ceil(iw/2)*2:ceil(ih/2)*2:color=${ground}`;
  // By itself ffmpeg takes the matrix of BT.601 and does not say so: players then guess, and show other colours.
  const matrix =
    "scale=out_color_matrix=bt709:out_range=tv:flags=bicubic+accurate_rnd+bitexact,format=yuv420p";
  const tags = "setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=iec61966-2-1";
  const planes = ["-vf", `${even},${matrix},${tags}`, "-pix_fmt", "yuv420p"];
  // Neither the hour nor the machine is to be seen in the file.
  const same = [
    "-map_metadata",
    "-1",
    "-fflags",
    "+bitexact",
    "-flags:v",
    "+bitexact",
    "-threads",
    `${THREADS}`,
  ];
  const file = ["-movflags", "+faststart", "-f", kind, "-y", `file:${path}`];
  return ["-hide_banner", "-loglevel", "error", ...raw, ...planes, ...same, ...file];
}

async function sent(path) {
  for await (const part of createReadStream(path)) await print(part);
}

export async function encoder(file, video) {
  const ending = `.${video.kind}`;
  const place = file === STANDARD ? placeApart(ending, sent) : await placeFor(file, ending);
  // Ctrl-C is told to us alone, and we end it.
  const detached = process.platform !== "win32";
  const ffmpeg = spawn("ffmpeg", wordsFor(place.path, video), {
    stdio: ["pipe", "ignore", "pipe"],
    detached,
  });
  running.add(ffmpeg);
  let said = "";
  ffmpeg.stderr.on("data", (text) => {
    said = `${said}${text}`.slice(-2000);
  });
  // It ends before its last frame where it cannot write: its exit tells why.
  ffmpeg.stdin.on("error", () => {});
  const ended = once(ffmpeg, "close").then(([code]) => {
    running.delete(ffmpeg);
    if (code === 0) return;
    place.drop();
    const why = said.trim().split("\n").at(-1)?.replaceAll(place.path, file);
    throw new Error(`ffmpeg could not make ${file}: ${why || `it ended with ${code}`}`);
  });
  ended.catch(() => {});
  return {
    add: (pixels) =>
      Promise.race([
        new Promise((resolve) => ffmpeg.stdin.write(pixels, (problem) => problem || resolve())),
        ended,
      ]),
    async finish() {
      ffmpeg.stdin.end();
      await ended;
      await place.keep();
    },
  };
}

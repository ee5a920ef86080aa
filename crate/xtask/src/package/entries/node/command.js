#!/usr/bin/env node
// The command `frond`: `node` gives it files, words and workers.
import { execFile, spawn } from "node:child_process";
import { once } from "node:events";
import { createReadStream } from "node:fs";
import { access, constants, stat, writeFile } from "node:fs/promises";
import { dirname } from "node:path";
import { parseArgs } from "node:util";
import { OPTIONS, run } from "../command.js";
import { createPool } from "./pool.js";

/** No file of maps is larger. */
const MOST_BYTES = 64e6;

const started = async (loading) => {
  const module = await loading;
  await module.default();
  return module;
};

let pool;
const system = {
  draw: () => started(import("./draw.js")),
  proof: () => started(import("./proof.js")),
  exchange: () => started(import("./exchange.js")),
  directed: () => started(import("./directed.js")),
  space: () => started(import("./space.js")),
  pool: () => {
    pool ??= createPool();
    return pool;
  },
  async read(file) {
    const parts = [];
    let length = 0;
    // Some files have no end.
    for await (const part of createReadStream(file)) {
      length += part.length;
      if (length > MOST_BYTES) throw new Error(`${file} is larger than 64 MB: it cannot be one of maps.`);
      parts.push(part);
    }
    return Buffer.concat(parts);
  },
  write: (file, bytes) => writeFile(file, bytes),
  async writable(file) {
    const folder = dirname(file);
    const there = await stat(folder).catch(() => null);
    if (!there?.isDirectory()) throw new Error(`There is no folder ${folder}: make it first.`);
    const old = await stat(file).catch(() => null);
    if (old?.isDirectory()) throw new Error(`${file} is a folder: name a file in it.`);
    await access(old ? file : folder, constants.W_OK);
  },
  encodes: () =>
    new Promise((resolve) => execFile("ffmpeg", ["-version"], (problem) => resolve(problem === null))),
  async encoder(file, { width, height, fps, ground }) {
    const frames = [
      "-f",
      "rawvideo",
      "-pix_fmt",
      "rgba",
      "-s",
      `${width}x${height}`,
      "-r",
      `${fps}`,
      "-i",
      "-",
    ];
    const even = `pad=ceil(iw/2)*2:ceil(ih/2)*2:color=${ground}`;
    // By itself ffmpeg takes the matrix of BT.601 and does not say so: players then guess, and show other colours.
    const matrix = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";
    const tags = "setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=iec61966-2-1";
    const planes = ["-vf", `${even},${matrix},${tags}`, "-pix_fmt", "yuv420p"];
    const video = [...planes, "-movflags", "+faststart", "-y", `file:${file}`];
    const words = ["-hide_banner", "-loglevel", "error", ...frames, ...video];
    const ffmpeg = spawn("ffmpeg", words, { stdio: ["pipe", "ignore", "pipe"] });
    let said = "";
    ffmpeg.stderr.on("data", (text) => {
      said = `${said}${text}`.slice(-2000);
    });
    // It ends before its last frame where it cannot write: its exit tells why.
    ffmpeg.stdin.on("error", () => {});
    const ended = once(ffmpeg, "close").then(([code]) => {
      const why = said.trim().split("\n").at(-1);
      if (code !== 0) throw new Error(`ffmpeg could not make ${file}: ${why || `it ended with ${code}`}`);
    });
    ended.catch(() => {});
    return {
      add: (pixels) =>
        Promise.race([
          new Promise((resolve) => ffmpeg.stdin.write(pixels, (problem) => problem || resolve())),
          ended,
        ]),
      finish() {
        ffmpeg.stdin.end();
        return ended;
      },
    };
  },
  print: (line) => process.stdout.write(`${line}\n`),
  tell: (line) => process.stderr.write(`${line}\n`),
};

const options = {
  ...Object.fromEntries(OPTIONS.map((name) => [name, { type: "string" }])),
  help: { type: "boolean", short: "h" },
};

/** What is wrong with the words, where Node says it at length. */
function plain(problem) {
  const words = {
    ENOENT: `There is no ${problem?.path}.`,
    EACCES: `${problem?.path} may not be opened.`,
    EROFS: `${problem?.path} may not be written.`,
    EISDIR: `${problem?.path ?? "This"} is a folder.`,
    ENOSPC: "The disk is full.",
  };
  const option = /'(-[^' ]+)/.exec(problem?.message)?.[1];
  if (problem?.code === "ERR_PARSE_ARGS_UNKNOWN_OPTION")
    return `There is no option ${option}. See frond --help.`;
  if (problem?.code === "ERR_PARSE_ARGS_INVALID_OPTION_VALUE")
    return `${option} needs a value after it. See frond --help.`;
  return words[problem?.code] ?? problem?.message ?? problem;
}

// Whoever listens may have heard enough.
process.stdout.on("error", () => process.exit());
try {
  const { positionals, values } = parseArgs({ options, allowPositionals: true });
  process.exitCode = await run(positionals, values, system);
} catch (problem) {
  system.tell(`frond: ${plain(problem)}`);
  process.exitCode = 2;
}
pool?.close();

#!/usr/bin/env node
// The command `frond`: `node` gives it files, words and workers.
import { createReadStream } from "node:fs";
import { readFile } from "node:fs/promises";
import { availableParallelism } from "node:os";
import { parseArgs } from "node:util";
import { OPTIONS, run } from "../command.js";
import { createPool } from "./command-pool.js";
import { inner, started } from "./modules.js";
import { removeUnfinished, STANDARD, writable, write } from "./output.js";
import { encoder, encodes, stopEncoders } from "./video.js";

/** No file that is read is larger. */
const MOST_BYTES = 64e6;

async function read(file) {
  const named = file === STANDARD ? "The standard input" : file;
  const parts = [];
  let length = 0;
  // Some files have no end.
  for await (const part of file === STANDARD ? process.stdin : createReadStream(file)) {
    length += part.length;
    if (length > MOST_BYTES)
      throw new Error(`${named} is larger than 64 MB, which is more than Frond reads.`);
    parts.push(part);
  }
  if (length === 0) throw new Error(`${named} is empty.`);
  return Buffer.concat(parts);
}

/** Whether words stand on the last line that are to be taken away. */
let watched = false;
const clear = () => {
  if (watched) process.stderr.write("\r\x1b[K");
  watched = false;
};

const { version } = JSON.parse(await readFile(new URL("../package.json", import.meta.url), "utf8"));

let pool;
const system = {
  version,
  draw: () => started(import("./draw.js")),
  proof: () => started(import("./proof.js")),
  exchange: () => started(import("./exchange.js")),
  exact: () => started(import("./exact.js")),
  directed: () => started(import("./directed.js")),
  space: () => started(import("./space.js")),
  curve: () => started(import("./curve.js")),
  fit: () => started(import("./fit.js")),
  tables: () => inner("frond-text"),
  drawings: () => inner("frond-svg"),
  pool: (size = availableParallelism()) => {
    pool ??= createPool(size);
    return pool;
  },
  read,
  present: (file) => readFile(file).catch(() => null),
  write,
  writable,
  encodes,
  encoder,
  print: (line) => process.stdout.write(`${line}\n`),
  tell(line) {
    clear();
    process.stderr.write(`${line}\n`);
  },
  ...(process.stderr.isTTY
    ? {
        rewrite(words) {
          clear();
          process.stderr.write(words);
          watched = words !== "";
        },
      }
    : {}),
  now: () => performance.now(),
};

const options = {
  ...Object.fromEntries(Object.entries(OPTIONS).map(([name, type]) => [name, { type }])),
  help: { type: "boolean", short: "h" },
  version: { type: "boolean" },
};

/** A number below zero is what an option is set to, and not an option of its own. */
function joined(words) {
  const made = [];
  for (const word of words) {
    const before = made.at(-1) ?? "";
    const takes = before.startsWith("--") && options[before.slice(2)]?.type === "string";
    if (takes && /^-[.\d]/.test(word)) made[made.length - 1] = `${before}=${word}`;
    else made.push(word);
  }
  return made;
}

/** What is wrong with the words, where Node says it at length. */
function plain(problem) {
  const words = {
    ENOENT: `There is no ${problem?.path}.`,
    EACCES: `${problem?.path} may not be opened.`,
    EPERM: `${problem?.path} may not be written.`,
    EROFS: `${problem?.path} may not be written.`,
    EISDIR: `${problem?.path ?? "This"} is a folder.`,
    ENOSPC: "The disk is full.",
  };
  const option = /'(-[^' ]+)/.exec(problem?.message)?.[1];
  if (problem?.code === "ERR_PARSE_ARGS_UNKNOWN_OPTION")
    return `There is no option ${option}. See frond --help.`;
  if (problem?.code === "ERR_PARSE_ARGS_INVALID_OPTION_VALUE") {
    const takes = options[option?.replace(/^-+/, "")]?.type !== "boolean";
    return `${option} ${takes ? "needs a value after it" : "has no value after it"}. See frond --help.`;
  }
  return words[problem?.code] ?? problem?.message ?? problem;
}

process.on("exit", () => {
  stopEncoders();
  removeUnfinished();
});
// Those who wait for it hear by the code that it was interrupted.
for (const [signal, code] of [
  ["SIGINT", 130],
  ["SIGTERM", 143],
  ["SIGHUP", 129],
])
  process.on(signal, () => {
    system.tell("frond: interrupted. What was not whole yet is gone.");
    process.exit(code);
  });
// Whoever listens may have heard enough.
process.stdout.on("error", () => process.exit());
try {
  const { positionals, values } = parseArgs({
    args: joined(process.argv.slice(2)),
    options,
    allowPositionals: true,
  });
  process.exitCode = await run(positionals, values, system);
} catch (problem) {
  system.tell(`frond: ${plain(problem)}`);
  process.exitCode = 2;
}
pool?.close();

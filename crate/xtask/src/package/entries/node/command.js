#!/usr/bin/env node
// The command `frond`: `node` gives it files, words and workers.
import { readFile, writeFile } from "node:fs/promises";
import { parseArgs } from "node:util";
import { run } from "../command.js";
import { createPool } from "./pool.js";

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
  pool: () => {
    pool ??= createPool();
    return pool;
  },
  read: (file) => readFile(file),
  write: (file, bytes) => writeFile(file, bytes),
  print: (line) => process.stdout.write(`${line}\n`),
  tell: (line) => process.stderr.write(`${line}\n`),
};

const names = ["out", "as", "width", "height", "t", "seconds", "fps", "background", "epsilon"];
const options = {
  ...Object.fromEntries(names.map((name) => [name, { type: "string" }])),
  help: { type: "boolean" },
};
// Whoever listens may have heard enough.
process.stdout.on("error", () => process.exit());
try {
  const { positionals, values } = parseArgs({ options, allowPositionals: true });
  process.exitCode = await run(positionals, values, system);
} catch (problem) {
  const words = {
    ENOENT: `There is no ${problem?.path}.`,
    EACCES: `${problem?.path} may not be opened.`,
    EISDIR: `${problem?.path ?? "This"} is a folder.`,
    ENOSPC: "The disk is full.",
  };
  system.tell(`frond: ${words[problem?.code] ?? problem?.message ?? problem}`);
  process.exitCode = 2;
}
pool?.close();

/** Programs and servers that the hosts need. */
import { spawn } from "node:child_process";
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";

const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".css": "text/css",
  ".wasm": "application/wasm",
};
/** No colours in what is printed, nothing asked, nothing told to anybody. */
const ENVIRONMENT = {
  ...process.env,
  NO_COLOR: "1",
  FORCE_COLOR: undefined,
  NO_UPDATE_NOTIFIER: "1",
  NEXT_TELEMETRY_DISABLED: "1",
  ASTRO_TELEMETRY_DISABLED: "1",
  DENO_NO_UPDATE_CHECK: "1",
};
/** A dev server that has not answered by then never will. */
const TRIES = 600;

/** What runs, each in a group of its own; none outlives this program, however that ends. */
const running = new Set();
process.on("exit", () => {
  for (const { stop } of running) stop();
});
for (const signal of ["SIGINT", "SIGTERM"]) process.on(signal, () => process.exit(130));

/** Starts a program, with what it prints and a way to end it and all that it has started. */
export function start(program, words, cwd, more = {}) {
  const child = spawn(program, words, {
    cwd,
    env: { ...ENVIRONMENT, ...more },
    detached: true,
    stdio: ["ignore", "pipe", "pipe"],
  });
  const printed = [];
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (bytes) => printed.push(bytes));
  let over = false;
  const ended = new Promise((resolve, reject) => {
    child.on("error", reject);
    child.on("close", (code) => {
      over = true;
      running.delete(started);
      resolve(code);
    });
  });
  const started = {
    ended,
    over: () => over,
    output: () => Buffer.concat(printed).toString(),
    stop: () => {
      try {
        if (!over && child.pid) process.kill(-child.pid, "SIGTERM");
      } catch {
        // It has ended since.
      }
    },
  };
  running.add(started);
  return started;
}

/** What a program prints that ends by itself. */
export async function run(program, words, cwd) {
  const started = start(program, words, cwd);
  const code = await started.ended;
  if (code !== 0)
    throw new Error(`\`${[program, ...words].join(" ")}\` ends with ${code}:\n${started.output()}`);
  return started.output();
}

export async function reached(address, server) {
  for (let i = 0; i < TRIES && !server.over(); i++) {
    const answer = await fetch(address).catch(() => null);
    if (answer?.ok) return;
    await new Promise((resolve) => setTimeout(resolve, 200));
  }
  throw new Error("it does not answer");
}

/** Serves a folder at the root of a host, with these headers for each file, and other folders below it. */
export async function serveFolder(folder, headers = {}, mounts = {}) {
  const server = createServer(async ({ url }, response) => {
    const path = decodeURIComponent(new URL(url, "http://here/").pathname);
    const mount = Object.keys(mounts).find((start) => path.startsWith(start));
    const asked = normalize(path.endsWith("/") ? `${path}index.html` : path);
    const file = mount ? join(mounts[mount], asked.slice(mount.length)) : join(folder, asked);
    try {
      const bytes = await readFile(file);
      response.writeHead(200, {
        "content-type": TYPES[extname(file)] ?? "application/octet-stream",
        ...headers,
      });
      response.end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return {
    address: `http://127.0.0.1:${server.address().port}/`,
    close: () => {
      server.close();
      server.closeAllConnections();
    },
  };
}

/** A port that nothing listens on. */
export async function freePort() {
  const server = createServer();
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address();
  await new Promise((resolve) => server.close(resolve));
  return port;
}

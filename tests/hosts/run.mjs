/**
 * Tries the package in the programs of others. Each folder beside this file is a project as a user would write it: it
 * is copied, installed from the registry with the package, built by its own tools, served, and looked at in Chromium.
 *
 *     node tests/hosts/run.mjs [name ..]
 *
 * FROND_PACKAGE is the folder of the package (target/package/frond), FROND_CHROMIUM the browser.
 */
import { cpSync, existsSync, mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { basename, join } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { HOSTS, pinsOf } from "./hosts.mjs";
import { look } from "./look.mjs";
import { freePort, reached, run, serveFolder, start } from "./servers.mjs";

const here = fileURLToPath(new URL(".", import.meta.url));
const root = join(here, "../..");
const built = process.env["FROND_PACKAGE"] ?? join(root, "target/package/frond");

const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !(name in HOSTS));
if (unknown.length > 0) {
  console.error(`There is no host ${unknown.join(", ")}. There are: ${Object.keys(HOSTS).join(", ")}.`);
  process.exit(2);
}
if (!existsSync(join(built, "frond-view.module.js"))) {
  console.error(`There is no package in ${built}. Run \`cargo xtask build\` first.`);
  process.exit(2);
}

const scratch = mkdtempSync(join(tmpdir(), "frond-hosts-"));
process.on("exit", () => rmSync(scratch, { recursive: true, force: true, maxRetries: 3 }));
const found = ["/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(existsSync);
const browser = await chromium.launch({
  executablePath: process.env["FROND_CHROMIUM"] ?? found,
  args: [
    "--no-sandbox",
    "--disable-background-networking",
    "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1, EXCLUDE localhost",
  ],
});

const failed = [];
try {
  await run("npm", ["pack", built, "--pack-destination", scratch], scratch);
  const tarball = join(
    scratch,
    readdirSync(scratch).find((name) => name.endsWith(".tgz")),
  );
  for (const [name, host] of Object.entries(HOSTS))
    if (wanted.length === 0 || wanted.includes(name)) {
      const began = Date.now();
      const told = (word, rest) =>
        console.log(
          `${word} ${name} ${versions(name, host)}  ${Math.round((Date.now() - began) / 1000)} s${rest}`,
        );
      try {
        await tried(name, host, tarball);
        told("ok", "");
      } catch (problem) {
        failed.push(name);
        told("FAILED", `\n${indented(problem.message)}`);
      }
    }
} finally {
  await browser.close();
}
if (failed.length > 0) {
  console.error(`\nFailed: ${failed.join(", ")}. Alone: cargo xtask test hosts -- ${failed.join(" ")}`);
  process.exit(1);
}

/** The programs that the host is made of, as its manifest pins them. */
function versions(name, { programs = [] }) {
  const pinned = pinsOf(join(here, name));
  const told = programs.map((program) => `${program} ${pinned[program]}`);
  return (name === "node" ? [`node ${process.versions.node}`] : told).join(" + ");
}

async function tried(name, host, tarball) {
  const app = join(scratch, name);
  cpSync(join(here, name), app, { recursive: true });
  for (const file of host.borrows ?? []) cpSync(join(here, file), join(app, basename(file)));
  const log = [];
  const say = (text) => log.push(text);
  await run("npm", ["install", "--no-audit", "--no-fund", "--save-exact", tarball], app);
  if (host.python) {
    await run("python3", ["-m", "venv", ".venv"], app);
    await run(".venv/bin/pip", ["install", "--quiet", "--requirement", "requirements.txt"], app);
  }
  try {
    for (const line of host.build ?? []) say(await run("npx", ["--no-install", ...line.split(" ")], app));
    refuseWarnings(log.join("\n"));
    host.after?.(app, log.join("\n"));
    if (host.serves !== undefined) {
      const mounts = host.studio ? { "/studio/": join(root, "dist") } : {};
      const server = await serveFolder(join(app, host.serves), host.headers, mounts);
      try {
        await look(browser, server.address, host);
      } finally {
        server.close();
      }
    }
    for (const line of [host.start, host.dev].filter(Boolean)) await whileRunning(line, app, host);
  } finally {
    rmSync(app, { recursive: true, force: true });
  }
}

/** A server of the host's own. */
async function whileRunning(line, app, host) {
  const port = await freePort();
  const [program, ...words] = line.replace("PORT", port).split(" ");
  const server = host.python
    ? start(join(app, ".venv/bin", program), words, app, { HOME: app })
    : start("npx", ["--no-install", program, ...words], app);
  try {
    const address = `http://localhost:${port}/${host.opens ?? ""}`;
    await reached(address, server);
    await look(browser, address, host);
    refuseWarnings(server.output(), host.usual);
  } catch (problem) {
    throw new Error(`\`${line}\`: ${problem.message}\n${server.output()}`);
  } finally {
    server.stop();
  }
}

function refuseWarnings(output, usual) {
  const lines = output
    .split("\n")
    .filter((line) => !usual?.test(line))
    .filter((line) => /\bwarn(ing)?s?\b/i.test(line) && !/\b(0|no) warnings?\b/i.test(line));
  if (lines.length > 0) throw new Error(`it warns:\n${output}`);
}

function indented(text) {
  return text.replace(/^/gm, "    ");
}

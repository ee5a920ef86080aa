/** The service worker: Frond without a network, with all that was loaded before. */
import { nameOf, surplus, wayOf } from "./keep";

/** What there is in a service worker, as far as it is used here. */
interface Worker {
  registration: { scope: string };
  clients: { claim(): Promise<void> };
  skipWaiting(): Promise<void>;
  addEventListener(type: "install" | "activate", listen: (event: Lasting) => void): void;
  addEventListener(type: "fetch", listen: (event: Fetching) => void): void;
  addEventListener(type: "message", listen: (event: Lasting & { data: unknown }) => void): void;
}
interface Lasting {
  waitUntil(work: Promise<unknown>): void;
}
interface Fetching extends Lasting {
  request: Request;
  respondWith(answer: Promise<Response>): void;
}

/** Told apart from those of other builds by its text; the build writes it. */
declare const FROND_BUILD: string;

const worker = self as unknown as Worker;
const scope = worker.registration.scope;
const CACHE = "frond";

/** What the pages that are open have loaded. */
const used = new Set<string>();

// A page always comes from the network where there is one, so that a new worker may serve an old page: nothing waits.
worker.addEventListener("install", (event) => event.waitUntil(worker.skipWaiting()));
worker.addEventListener("activate", (event) => event.waitUntil(worker.clients.claim()));

worker.addEventListener("fetch", (event) => {
  const way = wayOf(event.request, scope);
  if (way === null) return;
  event.respondWith(way === "copy" ? copyFirst(event) : freshFirst(event));
});

/** A page says what it has loaded, of which the first was there before this worker. */
worker.addEventListener("message", (event) => {
  const { keep } = (event.data ?? {}) as { keep?: unknown };
  if (Array.isArray(keep)) event.waitUntil(keepAll(keep.filter((url) => typeof url === "string")));
});

async function copyFirst(event: Fetching): Promise<Response> {
  return (await copyOf(event.request.url)) ?? (await fetched(event));
}

async function freshFirst(event: Fetching): Promise<Response> {
  try {
    return await fetched(event);
  } catch (problem) {
    const copy = await copyOf(event.request.url);
    if (copy) return copy;
    if (event.request.mode === "navigate") return away();
    throw problem;
  }
}

/** What stands where a page was never opened here. */
function away(): Response {
  const words = "You are off line, and this page was not opened here before. Frond itself is there:";
  return new Response(
    `<!doctype html><meta charset="utf-8"><meta name="color-scheme" content="light dark"><title>Off line</title><p>${words} <a href="${scope}">open it</a>.`,
    { headers: { "content-type": "text/html" } },
  );
}

async function fetched(event: Fetching): Promise<Response> {
  const answer = await fetch(event.request);
  if (answer.ok) event.waitUntil(put(event.request.url, answer.clone()));
  return answer;
}

/** Storage may be full, broken or forbidden: then there is no copy, and the page works all the same. */
async function copyOf(url: string): Promise<Response | undefined> {
  try {
    return await (await caches.open(CACHE)).match(nameOf(url));
  } catch {
    return undefined;
  }
}

async function put(url: string, answer: Response): Promise<void> {
  try {
    await (await caches.open(CACHE)).put(nameOf(url), answer);
    await trimSoon();
  } catch {
    // As above.
  }
}

async function keepAll(urls: readonly string[]): Promise<void> {
  const cache = await caches.open(CACHE);
  for (const url of urls) {
    if (wayOf({ method: "GET", url }, scope) === null) continue;
    const name = nameOf(url);
    used.add(name);
    if (await cache.match(name)) continue;
    try {
      const answer = await fetch(name);
      if (answer.ok) await cache.put(name, answer);
    } catch {
      // Another time.
    }
  }
  await trim();
}

/** Files come many at a time: their sizes are looked at once for all. */
const TOGETHER_MS = 2000;
let trimming: Promise<void> | null = null;

function trimSoon(): Promise<void> {
  trimming ??= new Promise((done) => setTimeout(done, TOGETHER_MS)).then(trim).finally(() => {
    trimming = null;
  });
  return trimming;
}

async function trim(): Promise<void> {
  const cache = await caches.open(CACHE);
  const kept = [];
  for (const request of await cache.keys()) {
    const bytes = (await (await cache.match(request))?.blob())?.size ?? 0;
    kept.push({ url: request.url, bytes });
  }
  for (const url of surplus(kept, used)) await cache.delete(url);
}

// What it is built of is part of it: another build is another worker, and its pages are told of it.
Object.assign(self, { build: FROND_BUILD });

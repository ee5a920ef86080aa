/** What is seen at each key, small: carved by a worker when nothing has changed for a while. */
import { effect, type ReadonlySignal, signal } from "@preact/signals";
import { space, spacePlaying, spaceView } from "#document/space/space";
import type { Space } from "#wasm/api";
import { type PictureRequest, pictureOf } from "#workers/space/complete-picture";
import { Frames } from "#workers/space/frames";
import { shownObject } from "#workers/space/shown";
import { colours, ground } from "../../stage/sight";

const shown = signal<readonly (ImageData | null)[]>([]);

/** By the number of the key; null until it is there. */
export const keyPictures: ReadonlySignal<readonly (ImageData | null)[]> = shown;

/** Twice what it measures on the page. */
const SIZE = { width: 160, height: 100 };
/** So long after the last change, in milliseconds. */
const REST_MS = 350;
const MOST_KEPT = 120;

const kept = new Map<string, ImageData>();

/** Draws them until the returned function is called. */
export function watchKeys(): () => void {
  let stop: AbortController | null = null;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const end = effect(() => {
    const now = space.value;
    const look = { palette: colours.value, ground: ground.value };
    const still = !spacePlaying.value;
    clearTimeout(timer);
    stop?.abort();
    if (!now?.timeline || !still) return;
    const ending = new AbortController();
    stop = ending;
    timer = setTimeout(() => void draw(now, look, ending.signal), REST_MS);
  });
  return () => {
    end();
    clearTimeout(timer);
    stop?.abort();
  };
}

type Look = Pick<PictureRequest, "palette" | "ground">;

async function draw(now: Space, look: Look, signal: AbortSignal): Promise<void> {
  const wanted = requestsOf(now, look);
  const images = wanted.map((request) => kept.get(JSON.stringify(request)) ?? null);
  shown.value = images;
  for (const [i, request] of wanted.entries()) {
    if (images[i] || !request) continue;
    try {
      const image = await pictureOf(request, { lane: 1, signal });
      if (signal.aborted) return;
      kept.set(JSON.stringify(request), image);
      images[i] = image;
      shown.value = [...images];
    } catch {
      // A moment that cannot be drawn has no picture here; the stage says why.
      if (signal.aborted) return;
    }
  }
  for (const key of kept.keys()) {
    if (kept.size <= MOST_KEPT) break;
    kept.delete(key);
  }
}

/** One for each key; null where its moment has no attractor. */
function requestsOf(now: Space, look: Look): (PictureRequest | null)[] {
  const fallback = spaceView.peek();
  if (!fallback) return [];
  let frames: Frames | null = null;
  try {
    frames = new Frames(now);
    const film = frames;
    return (now.timeline?.keys ?? []).map(({ at }) => {
      const frame = film.at(at);
      const objects = frame.objects.map((at, i) => shownObject(at, now.objects[i]));
      const view = frame.view ?? fallback;
      return { objects, view, light: now.light, ...SIZE, factor: 1, ...look };
    });
  } catch {
    return [];
  } finally {
    frames?.free();
  }
}

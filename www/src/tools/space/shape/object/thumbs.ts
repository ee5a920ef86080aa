/** Small pictures of shapes, carved by a worker. */
import { effect, type ReadonlySignal, signal } from "@preact/signals";
import { dark } from "#document/preferences";
import type { Look } from "#document/space/edits";
import { channelsOf } from "#style/hex";
import { palette } from "#style/palette";
import type { SpaceObject } from "#wasm/api";
import { solid } from "#wasm/space";
import { pictureOf } from "#workers/space/complete-picture";

export interface Subject {
  id: string;
  objects: readonly SpaceObject[];
  /** Its own light and sky. */
  look?: Look;
}

const SIZE = { width: 224, height: 168 };

const made = signal<ReadonlyMap<string, ImageBitmap>>(new Map());
/** What each was made of: the same again need not be carved. */
const keys = new Map<string, string>();

/** By id, as far as they are there. */
export const pictures: ReadonlySignal<ReadonlyMap<string, ImageBitmap>> = made;

/** Has pictures made, one after the other, and made again in the colours of another theme. Returns the end of it. */
export function makePictures(subjects: readonly Subject[]): () => void {
  let stop: AbortController | null = null;
  const dispose = effect(() => {
    const theme = dark.value ? "dark" : "light";
    stop?.abort();
    stop = new AbortController();
    void makeAll(subjects, theme, stop.signal);
  });
  return () => {
    dispose();
    stop?.abort();
  };
}

async function makeAll(
  subjects: readonly Subject[],
  theme: "dark" | "light",
  signal: AbortSignal,
): Promise<void> {
  for (const { id, objects, look } of subjects) {
    const key = `${theme} ${JSON.stringify(objects)}`;
    if (keys.get(id) === key) continue;
    try {
      const bitmap = await carved(objects, look, theme, signal);
      if (signal.aborted) return;
      keys.set(id, key);
      made.value = new Map(made.peek()).set(id, bitmap);
    } catch {
      if (signal.aborted) return;
      // Without a picture it can still be chosen.
    }
  }
}

async function carved(
  objects: readonly SpaceObject[],
  look: Look | undefined,
  theme: "dark" | "light",
  signal: AbortSignal,
): Promise<ImageBitmap> {
  const light = look?.light ?? solid.defaultSpace().light;
  const view = solid.defaultView({ objects: [...objects], light });
  const shown = objects.map(({ maps, moved, tint }) => ({
    maps: moved ? solid.conjugate3(maps, moved) : maps,
    ...(tint ? { tint } : {}),
  }));
  const image = await pictureOf(
    {
      objects: shown,
      view,
      light,
      ...SIZE,
      factor: 2,
      palette: palette(theme),
      ground:
        look?.background ?? getComputedStyle(document.documentElement).getPropertyValue("--stage").trim(),
    },
    { signal, lane: 1 },
  );
  if (look?.background) lay(image, look.background);
  return createImageBitmap(image);
}

/** Lays a picture on its sky. */
function lay({ data }: ImageData, sky: string): void {
  const under = channelsOf(sky);
  for (let at = 0; at < data.length; at += 4) {
    const alpha = (data[at + 3] ?? 0) / 255;
    for (const [k, channel] of under.entries())
      data[at + k] = (data[at + k] ?? 0) * alpha + channel * (1 - alpha);
    data[at + 3] = 255;
  }
}

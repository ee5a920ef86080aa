/** The picture of space as a file. */
import { signal } from "@preact/signals";
import { announce, notify, wordsOf } from "#document/notice";
import { space, spaceView } from "#document/space/space";
import { layOn } from "#workers/film/opaque";
import { pictureOf } from "#workers/space/complete-picture";
import { PAGE } from "./light/background";
import { colours, ground, sight } from "./stage/sight";
import { stageSize } from "./stage/state";

const LONG_SIDE = 2400;

/** Whether one is being made. */
export const savingPng = signal(false);

/** What is on the stage, complete and larger, on the background of the document; clear where that is the page's. */
export async function savePng(): Promise<void> {
  const now = sight.peek();
  const view = spaceView.peek();
  const light = space.peek()?.light;
  if (!now || !view || !light || savingPng.peek()) return;
  savingPng.value = true;
  announce("The picture is being made.");
  try {
    const stage = stageSize.peek();
    const larger = LONG_SIDE / Math.max(1, stage.width, stage.height);
    const image = await pictureOf({
      objects: now.objects,
      view,
      light,
      width: Math.max(1, Math.round(stage.width * larger)),
      height: Math.max(1, Math.round(stage.height * larger)),
      palette: colours.peek(),
      ground: ground.peek(),
      factor: 2,
    });
    const background = space.peek()?.background;
    if (background !== undefined && background !== PAGE) layOn(image.data, background);
    download(await pngOf(image));
  } catch (problem) {
    notify({ kind: "error", text: `The picture could not be saved: ${wordsOf(problem)}` });
  } finally {
    savingPng.value = false;
  }
}

function pngOf(image: ImageData): Promise<Blob> {
  const canvas = document.createElement("canvas");
  canvas.width = image.width;
  canvas.height = image.height;
  canvas.getContext("2d")?.putImageData(image, 0, 0);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => {
      if (blob) resolve(blob);
      else reject(new Error("the browser could not encode it."));
    }, "image/png");
  });
}

function download(blob: Blob): void {
  const objects = space.peek()?.objects ?? [];
  const name = objects.length === 1 ? (objects[0]?.name ?? "") : "space";
  const plain = name
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .slice(0, 40);
  const anchor = document.createElement("a");
  anchor.href = URL.createObjectURL(blob);
  anchor.download = `frond-${plain || "space"}.png`;
  anchor.click();
  setTimeout(() => URL.revokeObjectURL(anchor.href), 10_000);
}

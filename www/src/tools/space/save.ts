/** The picture of space as a file. */
import { space, spaceView } from "#document/space/space";
import { download, plainName, pngOf } from "#ui/files/download";
import { whileDrawn } from "#ui/files/saving";
import { layOn } from "#workers/film/opaque";
import { pictureOf } from "#workers/space/complete-picture";
import { PAGE } from "./light/light";
import { colours, ground, sight } from "./stage/sight";
import { stageSize } from "./stage/state";

const LONG_SIDE = 2400;
/** The lane that neither the stage nor what is short waits for. */
const LONG_WORK = 3;

/** Whether one is being made. */
let saving = false;

/** What is on the stage, complete and larger, on the background of the document; clear where that is the page's. */
export async function savePng(): Promise<void> {
  const now = sight.peek();
  const view = spaceView.peek();
  const light = space.peek()?.light;
  if (!now || !view || !light || saving) return;
  saving = true;
  await whileDrawn("save", async (signal) => {
    const stage = stageSize.peek();
    const larger = LONG_SIDE / Math.max(1, stage.width, stage.height);
    const image = await pictureOf(
      {
        objects: now.objects,
        view,
        light,
        width: Math.max(1, Math.round(stage.width * larger)),
        height: Math.max(1, Math.round(stage.height * larger)),
        palette: colours.peek(),
        ground: ground.peek(),
        factor: 2,
      },
      { signal, lane: LONG_WORK },
    );
    const background = space.peek()?.background;
    if (background !== undefined && background !== PAGE) layOn(image.data, background);
    download(await pngOf(canvasOf(image)), fileName());
  });
  saving = false;
}

function canvasOf(image: ImageData): HTMLCanvasElement {
  const canvas = document.createElement("canvas");
  canvas.width = image.width;
  canvas.height = image.height;
  canvas.getContext("2d")?.putImageData(image, 0, 0);
  return canvas;
}

function fileName(): string {
  const objects = space.peek()?.objects ?? [];
  return `frond-${plainName(objects.length === 1 ? (objects[0]?.name ?? "") : "", "space")}.png`;
}

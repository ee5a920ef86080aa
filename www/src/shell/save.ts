/** The picture on the stage as a file. */
import { bend, deformation } from "#document/deform/bend";
import type { Photograph } from "#document/deform/photograph";
import { pictureShown } from "#document/deform/picture";
import { selection, shown } from "#document/morph";
import { notify, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { stageStyle } from "#stage/look";
import { bentPicture, type SheetRequest } from "#stage/surface/sheet";
import { effectiveView, stageSize } from "#stage/view";
import { download, plainName, pngOf } from "#ui/files/download";
import { submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";

const LONG_SIDE = 2400;

/** The picture as it stands on the stage, larger, complete, on a transparent ground. */
export function savePicture(): void {
  const size = stageSize.peek();
  const view = effectiveView.peek();
  const larger = LONG_SIDE / Math.max(size.width, size.height, 1);
  const width = Math.max(1, Math.round(size.width * larger));
  const height = Math.max(1, Math.round(size.height * larger));
  const { colouring, palette } = stageStyle.peek();
  const bent = selection.peek() ? null : bend.peek();
  const shownView = { ...view, scale: view.scale * larger };
  const options = { width, height, view: shownView, colouring, palette, ...(bent ? { bend: bent } : {}) };
  notify({ kind: "info", text: "Drawing the picture to save …" });
  const photograph = pictureShown.peek();
  if (photograph) {
    saveBent(photograph, { bend: bent, parts: deformation.peek().parts, view: shownView, width, height });
    return;
  }
  submit(
    single<"picture">(
      "export",
      45,
      { kind: "picture", maps: shown.peek(), options },
      {
        accept: (bitmap) => void saveBitmap(bitmap),
        fail: notSaved,
      },
    ),
  );
}

/** Once the notice is seen. */
function saveBent(photograph: Photograph, request: SheetRequest): void {
  setTimeout(() => {
    try {
      createImageBitmap(bentPicture(photograph, request)).then(saveBitmap, notSaved);
    } catch (problem) {
      notSaved(problem);
    }
  });
}

function notSaved(problem: unknown): void {
  notify({ kind: "error", text: `The picture could not be saved: ${wordsOf(problem)}` });
}

async function saveBitmap(bitmap: ImageBitmap): Promise<void> {
  try {
    const canvas = document.createElement("canvas");
    canvas.width = bitmap.width;
    canvas.height = bitmap.height;
    canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
    bitmap.close();
    download(await pngOf(canvas), fileName());
  } catch (problem) {
    notSaved(problem);
  }
}

function fileName(): string {
  const { a, b, t } = scene.peek();
  const plain = (name: string) => plainName(name, "shape", 24);
  return `frond-${plain(a.name)}-${plain(b.name)}-${t.toFixed(2)}.png`;
}

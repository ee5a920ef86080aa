/** What can be done with the document as a whole: its link, and files of it. */
import { computed } from "@preact/signals";
import { curved } from "#document/curve/curve";
import { bend, deformation } from "#document/deform/bend";
import type { Photograph } from "#document/deform/photograph";
import { ownPicture, pictureShown } from "#document/deform/picture";
import { addressBar, Link } from "#document/link";
import { selection, shown } from "#document/morph";
import { notify, wordsOf } from "#document/notice";
import { spacePlaying } from "#document/playback";
import { scene } from "#document/scene";
import { stageStyle } from "#stage/look";
import { bentPicture, type SheetRequest } from "#stage/surface/sheet";
import { effectiveView, stageSize } from "#stage/view";
import { adoptPath } from "#tools/morph/locus/path/automatic";
import { download, plainName, pngOf } from "#ui/files/download";
import type { Tool } from "#wasm/api";
import { frond } from "#wasm/core";
import { submit } from "#workers/pool/engine";
import { single } from "#workers/pool/protocol";
import { openedTool } from "./tools";

/** The one link between this page's document and its address. */
export const link = new Link(frond, addressBar, () => {
  selection.value = null;
  spacePlaying.value = false;
  adoptPath();
});

/** Where the studio is, with the document as it stands now and a tool, that which is open by default. */
export function studioHref(tool?: Tool): string {
  return `#${link.fragment(tool ? { tool } : {}) ?? ""}`;
}

/** Puts the address of the present document on the clipboard; not that of an earlier one, where none can hold it. */
export async function shareLink(): Promise<void> {
  if (!link.flush()) return;
  const { href } = location;
  try {
    await navigator.clipboard.writeText(href);
    const whole = pictureShown.peek() === null || !ownPicture.peek();
    notify({
      kind: "info",
      text: whole
        ? `Link copied. Whoever opens it sees ${await seen()}.`
        : "Link copied. It holds the bend, and not the picture: that stays here.",
    });
  } catch {
    notify({ kind: "info", text: "The link is in the address bar: copying it was not allowed here." });
  }
}

/** What is the same for all who open the link: the background belongs to a picture of space, and else to the page. */
async function seen(): Promise<string> {
  if (scene.peek().tool !== "space") return "the same, light or dark as their page is";
  const { space } = await import("#document/space/space");
  const background = space.peek()?.background;
  const page = background === undefined || background === "page";
  return page ? "the same shapes, before the colour of their own page" : "the same picture";
}

const LONG_SIDE = 2400;

/** The files that a closed curve can be saved as. */
export const CURVE_FILES = ["png", "svg", "csv", "json"] as const;

export async function saveCurve(kind: (typeof CURVE_FILES)[number]): Promise<void> {
  try {
    await (await import("#curve/save")).save(kind);
  } catch (problem) {
    notSaved(problem);
  }
}

/** Whether a closed curve is what would be saved. */
export const curveOnStage = computed(() => curved.value && !pictureShown.value);

/** The picture as it stands on the stage, larger, complete, on a transparent ground. */
export function savePicture(): void {
  const { entry, tool } = openedTool();
  if (entry.stage !== undefined) {
    void tool?.savePng?.();
    return;
  }
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

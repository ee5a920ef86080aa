/**
 * The studio on paper: what a graphics card draws does not come there, so a complete picture stands in, with the maps
 * and the link. Plain nodes and no component: it has to be there before `beforeprint` returns.
 */
import { effect } from "@preact/signals";
import { bend } from "#document/deform/bend";
import { pictureShown } from "#document/deform/picture";
import { selection, shown, shownColours } from "#document/morph";
import { scene } from "#document/scene";
import { endsOf, standIn } from "#document/stand-in";
import { percent } from "#format/path-words";
import { weighted } from "#geometry/maps/weighted";
import { shownWeights } from "#stage/picture-style";
import { effectiveView, stageSize } from "#stage/view";
import { WHITE } from "#style/colours";
import type { NamedMaps } from "#ui/files/exporting";
import { whileDrawn } from "#ui/files/saving";
import { loadBends, rasterize } from "#wasm/bend";
import { makePicture } from "#workers/film/picture";
import { addressOf, stageStill } from "../save";
import { openedTool } from "../tools";
import * as messages from "./messages";
import css from "./print.module.css";

/** Pixels of the picture for each of the stage. */
const FINE = 2;

// The browser prints at once: what draws densities has to be there before.
effect(() => {
  if (scene.value.colouring === "density") loadBends().catch(() => {});
});

let sheet: HTMLElement | null = null;
/** What stands behind the # of the link. */
let fragment: () => string | null = () => null;

/** From now on the studio can be printed, by whatever opens the browser's dialog. */
export function printable(ofLink: () => string | null): void {
  fragment = ofLink;
  addEventListener("beforeprint", () => {
    if (!sheet) lay(atOnce());
  });
  addEventListener("afterprint", () => {
    sheet?.remove();
    sheet = null;
  });
}

/** Waits for the picture, whatever the tool, and then asks the browser to print. */
export async function print(): Promise<void> {
  const { entry, tool } = openedTool();
  const still = entry.stage === undefined ? stageStill : tool?.still;
  if (!still) return window.print();
  await whileDrawn("print", async (signal, dismissed) => {
    const { subject, at, stage } = await still();
    const width = Math.round(Math.max(1, FINE * stage.width));
    const height = Math.round(Math.max(1, FINE * stage.height));
    const settings = { width, height, ground: WHITE, link: null };
    const { bytes, type } = await makePicture({ subject, at, settings, smooth: true }, signal, () => {});
    const url = URL.createObjectURL(new Blob([bytes], { type }));
    try {
      const image = new Image();
      image.src = url;
      await image.decode();
      lay(image);
      // The page stands still while it is printed.
      dismissed();
      window.print();
    } finally {
      URL.revokeObjectURL(url);
    }
  });
}

/** The picture as far as it can be had without waiting. */
function atOnce(): HTMLElement {
  const { entry } = openedTool();
  const { width, height } = stageSize.peek();
  if (entry.stage === undefined && !pictureShown.peek() && !standIn.peek() && width > 0 && height > 0) {
    const canvas = document.createElement("canvas");
    canvas.width = FINE * Math.round(width);
    canvas.height = FINE * Math.round(height);
    const seen = effectiveView.peek();
    const bent = selection.peek() ? null : bend.peek();
    const options = {
      width: canvas.width,
      height: canvas.height,
      view: { ...seen, scale: FINE * seen.scale },
      colouring: scene.peek().colouring,
      palette: shownColours("light"),
      lightGround: true,
      ...(bent ? { bend: bent } : {}),
    };
    try {
      const pixels = new Uint8ClampedArray(rasterize(weighted(shown.peek(), shownWeights.peek()), options));
      canvas.getContext("2d")?.putImageData(new ImageData(pixels, canvas.width, canvas.height), 0, 0);
      return canvas;
    } catch {
      // There is nothing to be seen at this moment.
    }
  }
  const { tool } = openedTool();
  const waits = entry.stage === undefined || tool?.still !== undefined;
  return textOf("p", waits ? messages.thisPictureTakesMoment : messages.savePictureFromSave);
}

function lay(picture: HTMLElement): void {
  sheet?.remove();
  const { entry, tool } = openedTool();
  // What stands in place of the systems has maps of another kind.
  const maps = standIn.peek() && entry.stage === undefined ? [] : (tool?.maps?.() ?? []);
  const made = document.createElement("section");
  made.className = css["print-sheet"] ?? "";
  picture.classList.add(css["print-picture"] ?? "");
  made.append(textOf("h1", title()), picture, ...maps.map(mapsOf));
  const address = addressOf(fragment());
  if (address !== null) {
    const anchor = document.createElement("a");
    anchor.href = address;
    anchor.textContent = address;
    made.append(anchor);
  }
  document.querySelector(".studio")?.append(made);
  sheet = made;
}

function title(): string {
  const { t, tool } = scene.peek();
  const { a, b } = endsOf(scene.peek());
  if (tool === "space") return messages.frondSceneInSpace;
  if (tool === "fit") return messages.frondFractalCurve;
  return a.name === b.name ? a.name : messages.toAt(a.name, b.name, percent(t));
}

/** Digits of a number on paper; the link has all. */
const DIGITS = 8;

function mapsOf({ label, name, maps }: NamedMaps): HTMLElement {
  const table = document.createElement("table");
  table.createCaption().textContent = `${label}: ${name}`;
  const names = maps[0]?.length === 12 ? [..."abcdefghixyz"] : [..."abcdef"];
  const head = table.createTHead().insertRow();
  for (const letter of names) head.append(textOf("th", letter));
  const body = table.createTBody();
  for (const row of maps) {
    const line = body.insertRow();
    for (const number of row) line.insertCell().textContent = String(Number(number.toPrecision(DIGITS)));
  }
  return table;
}

function textOf(tag: "h1" | "p" | "th", text: string): HTMLElement {
  const element = document.createElement(tag);
  element.textContent = text;
  return element;
}

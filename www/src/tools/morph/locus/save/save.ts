/** The map of parameters as files: numbers for other programs, and a picture with its axes. */
import { locusWindow } from "#compute/results";
import { notify, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import { atAll } from "#geometry/states";
import { type LocusStyle, paint } from "#stage/locus/paint";
import { download, plainName, pngOf } from "#ui/files/download";
import { loadExchange } from "#wasm/exchange";
import { shownField } from "../view/shown";
import { epsilon, family, shownWindow, sides } from "../view/view";
import { drawAxes, MARGIN } from "./axes";

export type LocusFile = "png" | "csv" | "npy";

/** Pixels along a side of the square. */
const SIZE = 1600;

/** Saves what the map shows, as far as it is known. */
export async function saveLocus(kind: LocusFile, style: LocusStyle): Promise<void> {
  try {
    const field = shownField.peek();
    if (!field) throw new Error("Nothing is known of the map yet. Wait a moment.");
    const { width, gap, bounds } = field;
    const states = Uint8Array.from(field.state, atAll);
    const rectangle = Float64Array.of(bounds.u0, bounds.u1, bounds.v0, bounds.v1);
    if (kind === "png") {
      download(await pngOf(picture(field, style)), `${fileName()}.png`);
    } else if (kind === "csv") {
      const text = (await loadExchange()).locusCsv(rectangle, width, states, gap);
      download(new Blob([text], { type: "text/csv" }), `${fileName()}.csv`);
    } else {
      const bytes = (await loadExchange()).locusNpy(rectangle, width, states, gap);
      download(new Blob([new Uint8Array(bytes)]), `${fileName()}.npy`);
    }
    if ((locusWindow.peek()?.progress ?? 1) < 1) {
      const text = "The map is not complete yet: what was not decided is left open in the file.";
      notify({ kind: "info", text });
    }
  } catch (problem) {
    notify({ kind: "error", text: `The map could not be saved: ${wordsOf(problem)}` });
  }
}

function fileName(): string {
  if (family.peek() === "polygon") return `frond-family-${sides.peek()}`;
  const { a, b } = scene.peek();
  return `frond-map-${plainName(a.name, "a", 20)}-${plainName(b.name, "b", 20)}`;
}

function picture(field: Parameters<typeof paint>[0], style: LocusStyle): HTMLCanvasElement {
  const window = shownWindow.peek();
  const pixels = paint(field, SIZE, { style, scale: 2, epsilon: epsilon.peek(), window });
  const square = document.createElement("canvas");
  square.width = SIZE;
  square.height = SIZE;
  square.getContext("2d")?.putImageData(new ImageData(pixels, SIZE, SIZE), 0, 0);
  const canvas = document.createElement("canvas");
  canvas.width = SIZE + MARGIN.left + MARGIN.right;
  canvas.height = SIZE + MARGIN.top + MARGIN.bottom;
  const context = canvas.getContext("2d");
  if (!context) throw new Error("The browser gives no canvas.");
  const names = family.peek() === "morph" ? { across: "u", up: "v" } : { across: "Re s", up: "Im s" };
  drawAxes(context, SIZE, window, names, () => context.drawImage(square, MARGIN.left, MARGIN.top));
  return canvas;
}

/** The map of parameters as files: numbers for other programs, and a picture with its axes. */
import { locusWindow, pathBreaks } from "#compute/results";
import { pathPoints } from "#document/morph";
import { notify, wordsOf } from "#document/notice";
import { scene } from "#document/scene";
import type { Uv } from "#geometry/path";
import { piecesIn, slice, sliced } from "#geometry/polyline";
import { atAll } from "#geometry/states";
import { type LocusStyle, paint } from "#stage/locus/paint";
import { download, plainName, pngOf } from "#ui/files/download";
import { loadExchange } from "#wasm/exchange";
import { around, linePath, THICK } from "../marks";
import * as messages from "../messages";
import { isOutside } from "../path/handles";
import { place } from "../path/waypoints";
import { epsilon, family, shownField, shownWindow, sides, view } from "../view/view";
import { drawAxes, MARGIN, mapDrawing } from "./drawing";

/** `path`: the path alone, as a drawing; `svg` has the map as well. */
export type LocusFile = "png" | "svg" | "path" | "csv" | "npy";

/** Pixels along a side of the square. */
const SIZE = 1600;

/** Saves what the map shows, as far as it is known. */
export async function saveLocus(kind: LocusFile, style: LocusStyle): Promise<void> {
  try {
    const field = shownField.peek();
    if (!field) throw new Error(messages.locusHasNotBeen);
    const { width, gap, bounds } = field;
    const states = Uint8Array.from(field.state, atAll);
    if (kind === "png") {
      download(await pngOf(picture(field, style)), `${fileName()}.png`);
    } else if (kind === "svg" || kind === "path") {
      const name = kind === "path" ? `${fileName()}-path` : fileName();
      download(new Blob([drawing(field, style, kind === "path")], { type: "image/svg+xml" }), `${name}.svg`);
      if (kind === "path") return;
    } else if (kind === "csv") {
      const text = (await loadExchange()).locusCsv(bounds, width, states, gap);
      download(new Blob([text], { type: "text/csv" }), `${fileName()}.csv`);
    } else {
      const bytes = (await loadExchange()).locusNpy(bounds, width, states, gap);
      download(new Blob([new Uint8Array(bytes)]), `${fileName()}.npy`);
    }
    if ((locusWindow.peek()?.progress ?? 1) < 1) {
      const text = messages.locusNotCompleteYet;
      notify({ kind: "info", text });
    }
  } catch (problem) {
    notify({ kind: "error", text: messages.locusNotSaved(wordsOf(problem)) });
  }
}

function fileName(): string {
  if (family.peek() === "polygon") return `frond-family-${sides.peek()}`;
  const { a, b } = scene.peek();
  return `frond-map-${plainName(a.name, "a", 20)}-${plainName(b.name, "b", 20)}`;
}

const namesOf = () => (family.peek() === "morph" ? { across: "u", up: "v" } : { across: "Re s", up: "Im s" });

function drawing(field: Parameters<typeof paint>[0], style: LocusStyle, alone: boolean): string {
  const window = shownWindow.peek();
  const { a, b } = scene.peek();
  const map = { window, names: namesOf(), areas: { field, style, epsilon: epsilon.peek() } };
  if (family.peek() === "polygon") return mapDrawing({ ...map, title: messages.polygonsOf(sides.peek()) });
  const points = pathPoints.peek();
  const within = around();
  const lines = (pieces: [Uv, Uv][]) => linePath(pieces.flatMap((piece) => piecesIn(piece, within)));
  const whole = sliced(points, view.peek().w, THICK);
  const broken = pathBreaks.peek().map(({ t0, t1 }) => sliced(slice(points, t0, t1), view.peek().w, THICK));
  const { areas, ...axes } = map;
  return mapDrawing({
    ...axes,
    ...(alone ? {} : { areas }),
    title: messages.fromTo(a.name, b.name),
    path: {
      whole: lines(whole.near),
      faint: lines(whole.far),
      broken: lines(broken.flatMap(({ near }) => near)),
      faintBroken: lines(broken.flatMap(({ far }) => far)),
    },
    ends: [
      { letter: "A", at: place([0, 0], window) },
      { letter: "B", at: place([1, 1], window) },
    ].filter(({ at }) => !isOutside(at)),
  });
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
  if (!context) throw new Error(messages.browserCouldNotCreate);
  drawAxes(context, SIZE, window, namesOf(), () => context.drawImage(square, MARGIN.left, MARGIN.top));
  return canvas;
}

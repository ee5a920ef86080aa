import { useEffect, useMemo, useRef, useState } from "preact/hooks";
import { type Box, fitFor } from "#document/framing";
import { dark } from "#document/preferences";
import type { Size } from "#geometry/coordinates";
import { GREY } from "#style/colours";
import { palette } from "#style/palette";
import type { Bend, Colouring, MapRow } from "#wasm/api";
import { bendsFor } from "#wasm/bend";
import type { Task } from "#workers/pool/protocol";
import { useRested } from "../rest";
import { useAsk, useValue } from "../workers";
import { pictured, usePixels } from "./canvas";
import css from "./picture.module.css";

export interface PictureProps {
  maps: MapRow[];
  /** What part of the plane is shown. Several pictures with the same box can be compared. */
  box: Box;
  /** What is seen, in words; null for a picture that its surroundings describe. */
  label: string | null;
  margin?: number;
  priority?: number;
  colouring?: Colouring;
  /** The place of each map among the colours, where it is not its place among the maps. */
  hues?: readonly number[] | undefined;
  /** What bends it. While it changes the picture is coarse, so that it follows. */
  bend?: Bend;
}

/** How much coarser it is until what bends it rests. */
const COARSE = 2;

/** An attractor, drawn by a worker, as large as its place. */
export function Picture({
  maps,
  box,
  label,
  margin = 0.05,
  priority = 44,
  colouring = "map",
  hues,
  bend,
}: PictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const full = usePixels(canvas);
  const onDark = useValue(dark);
  const coarse = useRested(bend) !== bend;
  const [shown, setShown] = useState<Task<"picture"> | null>(null);
  const bends = useBends(bend, colouring);
  const task = useMemo<Task<"picture"> | null>(() => {
    if (full === null || bends === null) return null;
    const size = coarse ? coarser(full) : full;
    const view = fitFor(box, size, margin);
    const all = palette(onDark ? "dark" : "light");
    const colours = hues ? hues.map((hue) => all[hue % all.length] ?? GREY) : all;
    const options = { ...size, view, colouring, palette: colours };
    return { kind: "picture", maps, options: bend ? { ...options, bend } : options, bends };
  }, [maps, box, full, coarse, margin, onDark, colouring, hues, bend, bends]);
  useAsk<"picture">(task, priority, {
    accept(about, bitmap) {
      if (canvas.current) paint(canvas.current, bitmap);
      bitmap.close();
      setShown(about);
    },
    // Without an attractor there is nothing to see, and the verdict beside it says so. What cannot be bent stays as it
    // was.
    fail(about) {
      if (canvas.current && !about.options.bend) canvas.current.width += 0;
    },
  });
  return (
    <canvas
      ref={canvas}
      class={css["figure-picture"]}
      data-flat=""
      data-complete={task !== null && shown === task && !coarse ? "" : undefined}
      {...pictured(label)}
    />
  );
}

/** What the worker has to be handed: null until it is fetched. */
function useBends(bend: Bend | undefined, colouring: Colouring): WebAssembly.Module | undefined | null {
  const [bends, setBends] = useState<WebAssembly.Module | null>(null);
  const asked = bendsFor(bend ? { bend, colouring } : { colouring });
  useEffect(() => {
    asked?.then(setBends, () => {});
  }, [asked]);
  return asked && bends;
}

function paint(canvas: HTMLCanvasElement, bitmap: ImageBitmap): void {
  canvas.width = bitmap.width;
  canvas.height = bitmap.height;
  canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
}

function coarser({ width, height }: Size) {
  return { width: Math.max(1, Math.round(width / COARSE)), height: Math.max(1, Math.round(height / COARSE)) };
}

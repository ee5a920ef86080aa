import { useEffect, useMemo, useRef } from "preact/hooks";
import { type Box, fitFor } from "#document/framing";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import type { DirectedIfs } from "#wasm/api";
import { pictured, usePixels } from "../picture/canvas";
import picture from "../picture/picture.module.css";
import { useValue } from "../workers";
import { useDirected } from "./ask";

interface StatePictureProps {
  system: DirectedIfs;
  state: number;
  box: Box;
  /** 0: colours tell the map; above, the state that is copied after so many maps. */
  level: number;
  /** What is seen, in words; null where the surroundings say it. */
  label: string | null;
}

const MARGIN = 0.05;

/** A state of a graph-directed system, drawn complete by a worker, as large as its place. */
export function StatePicture({ system, state, box, level, label }: StatePictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const size = usePixels(canvas);
  const onDark = useValue(dark);
  const args = useMemo(() => {
    if (size === null) return null;
    const view = fitFor(box, size, MARGIN);
    return { system, options: { ...size, state, view, level, palette: palette(onDark ? "dark" : "light") } };
  }, [system, state, box, level, size, onDark]);
  const answer = useDirected("picture", args, 0);
  useEffect(() => {
    const bitmap = answer?.result;
    if (!bitmap || !canvas.current) return;
    canvas.current.width = bitmap.width;
    canvas.current.height = bitmap.height;
    canvas.current.getContext("2d")?.drawImage(bitmap, 0, 0);
    bitmap.close();
  }, [answer]);
  return (
    <canvas
      ref={canvas}
      class={picture["figure-picture"]}
      data-flat=""
      data-complete={args !== null && answer?.about === args && answer.result ? "" : undefined}
      {...pictured(label)}
    />
  );
}

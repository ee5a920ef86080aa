import { useLayoutEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import { palette } from "#style/palette";
import type { MapRow3, Point3 } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "./messages";
import css from "./shadow.module.css";

const POINTS = 30_000;
const WIDTH = 672;
const HEIGHT = 400;
const MARGIN = 16;

interface ShadowPictureProps {
  maps: MapRow3[];
  /** Of the light. */
  direction: Point3;
  points?: number;
}

/** The shadow in points, each in the colour of its map. */
export function ShadowPicture({ maps, direction, points = POINTS }: ShadowPictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const theme = dark.value ? "dark" : "light";
  const [x, y, z] = direction;
  useLayoutEffect(() => {
    const context = canvas.current?.getContext("2d");
    if (!context) return;
    context.clearRect(0, 0, WIDTH, HEIGHT);
    try {
      paint(context, maps, { direction: [x, y, z], points, colours: palette(theme) });
    } catch {
      // Without an attractor there is no shadow, and the words below say so.
    }
  }, [maps, x, y, z, points, theme]);
  return (
    <canvas
      ref={canvas}
      class={css["shadow-picture"]}
      width={WIDTH}
      height={HEIGHT}
      role="img"
      aria-label={messages.objectsShadow}
    />
  );
}

function paint(
  context: CanvasRenderingContext2D,
  maps: MapRow3[],
  { direction, points, colours }: { direction: Point3; points: number; colours: readonly string[] },
): void {
  if (maps.length === 0) return;
  const { right, up } = solid.shadow(maps, direction, { points: 1, seed: 1 });
  const { positions, pieces } = solid.attractor3(maps, { points, seed: 1 });
  const flat = new Float32Array((positions.length / 3) * 2);
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (let i = 0; i < flat.length / 2; i++) {
    for (const [k, axis] of [right, up].entries()) {
      let sum = 0;
      for (let j = 0; j < 3; j++) sum += (axis[j] ?? 0) * (positions[3 * i + j] ?? 0);
      flat[2 * i + k] = sum;
      low[k] = Math.min(low[k] ?? 0, sum);
      high[k] = Math.max(high[k] ?? 0, sum);
    }
  }
  const [x0 = 0, y0 = 0] = low;
  const [x1 = 0, y1 = 0] = high;
  const scale = Math.min((WIDTH - 2 * MARGIN) / (x1 - x0 || 1), (HEIGHT - 2 * MARGIN) / (y1 - y0 || 1));
  for (let map = 0; map < maps.length; map++) {
    context.fillStyle = colours[map % colours.length] ?? "gray";
    for (let i = 0; i < flat.length / 2; i++) {
      if (pieces[i] !== map) continue;
      const left = WIDTH / 2 + ((flat[2 * i] ?? 0) - (x0 + x1) / 2) * scale;
      const top = HEIGHT / 2 - ((flat[2 * i + 1] ?? 0) - (y0 + y1) / 2) * scale;
      context.fillRect(left - 0.75, top - 0.75, 1.5, 1.5);
    }
  }
}

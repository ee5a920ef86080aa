import { useCallback, useMemo } from "preact/hooks";
import type { MapRow3, SpaceView } from "#wasm/api";
import { type Sheet, useDrawing } from "../../kit/picture/canvas";
import pictureCss from "../../kit/picture/picture.module.css";
import { dotsOf, seen } from "./eye";
import { orbitLabel, useOrbit } from "./orbit";
import css from "./space.module.css";

const POINTS = 9000;

interface SpaceDotsProps {
  maps: readonly MapRow3[];
  view: SpaceView;
  /** Taken when somebody turns the view; without it the view stands. */
  onView?: (view: SpaceView) => void;
  /** What is seen, in words; none for a picture that its surroundings describe. */
  label?: string;
  points?: number;
}

/** A picture of space in points, which needs nothing to be fetched. What is far is fainter. */
export function SpaceDots({ maps, view, onView, label, points = POINTS }: SpaceDotsProps) {
  const dots = useMemo(() => dotsOf(maps, points), [maps, points]);
  const draw = useCallback(
    ({ context, width, height, colours }: Sheet) => {
      const place = seen(view);
      const places = dots.map(({ point, map }) => ({ at: place(point), map })).filter(({ at }) => at[2] > 0);
      const depths = places.map(({ at }) => at[2]);
      const [near, far] = [Math.min(...depths), Math.max(...depths)];
      const half = height / 2;
      const size = Math.max(1, height / 320);
      // The far ones first: what is near covers them.
      for (const { at, map } of places.toSorted((a, b) => b.at[2] - a.at[2])) {
        const [x, y, depth] = at;
        context.globalAlpha = 1 - 0.65 * ((depth - near) / (far - near || 1));
        context.fillStyle = colours[map % colours.length] ?? "gray";
        context.fillRect(width / 2 + x * half - size / 2, half - y * half - size / 2, size, size);
      }
    },
    [dots, view],
  );
  const { canvas } = useDrawing(draw);
  const orbit = useOrbit(view, onView);
  return (
    <canvas
      ref={canvas}
      class={`${pictureCss["figure-picture"]} ${onView ? `${css["space-picture"]} ${css["turned"]}` : ""}`}
      {...(label === undefined ? {} : orbitLabel(label, onView !== undefined))}
      {...orbit}
    />
  );
}

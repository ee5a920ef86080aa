/** The point that is followed, drawn over the picture: it can be dragged, and moved by keys. */
import { useEffect } from "preact/hooks";
import { type Screen, screen } from "#geometry/coordinates";
import type { Point } from "#geometry/maps/orbit";
import { pictureTap } from "#stage/gestures";
import { useGrip } from "#stage/grip";
import { stageStyle } from "#stage/picture-style";
import { stageSize } from "#stage/view";
import { Cell, OrbitPath } from "#ui/orbit/OrbitPath";
import * as messages from "./messages";
import css from "./orbit-overlay.module.css";
import {
  cell,
  followed,
  game,
  goTo,
  grip,
  hindrance,
  mapAt,
  orbit,
  place,
  playing,
  pointAtScreen,
  thrownPoints,
  throws,
  throwTo,
} from "./state";

export function OrbitOverlay() {
  useEffect(() => {
    pictureTap.does = (at) => {
      if (hindrance.peek()) return;
      const point = pointAtScreen(at);
      if (playing.peek()) throwTo(mapAt(point));
      else goTo(point);
    };
    return () => {
      pictureTap.does = null;
    };
  }, []);
  if (hindrance.value) return null;
  const size = stageSize.value;
  return (
    <>
      <svg class="overlay quiet" {...size} aria-hidden="true">
        {playing.value ? <Target /> : <Path />}
      </svg>
      {!playing.value && (
        <svg class="overlay" {...size}>
          <title>{messages.followedPoint}</title>
          <Chosen />
        </svg>
      )}
    </>
  );
}

const placed = (point: Point): [number, number] => {
  const { x, y } = place(point);
  return [x, y];
};

function Target() {
  return (
    <>
      <Cell corners={cell.value} place={placed} reached={game.value.reached} />
      <OrbitPath
        points={thrownPoints.value}
        letters={throws.value}
        colours={stageStyle.value.palette ?? []}
        place={placed}
      />
    </>
  );
}

function Path() {
  const { points, letters } = followed.value;
  return (
    <OrbitPath
      points={points}
      letters={letters}
      colours={stageStyle.value.palette ?? []}
      place={placed}
      inverse={orbit.value.way === "read"}
    />
  );
}

const STEP = 8;
const FINE = 1;
const ARROWS: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** The point that was chosen, to be taken hold of. */
function Chosen() {
  const moveTo = (to: Screen) => goTo(pointAtScreen(to));
  const ref = useGrip({
    take: (event) => {
      event.stopPropagation();
      return grip.peek();
    },
    moveTo,
    key(event) {
      const step = ARROWS[event.key];
      if (!step || event.ctrlKey || event.metaKey || event.altKey) return false;
      const far = event.shiftKey ? FINE : STEP;
      const { x, y } = grip.peek();
      moveTo(screen(x + far * step[0], y + far * step[1]));
      return true;
    },
  });
  const { x, y } = grip.value;
  return (
    // biome-ignore lint/a11y/useSemanticElements: there are no buttons in SVG
    <g
      class={`grip ${css["chosen-point"]}`}
      data-handle=""
      role="button"
      tabindex={0}
      aria-label={messages.selectedPointArrowKeys}
      transform={`translate(${x.toFixed(1)} ${y.toFixed(1)})`}
      ref={ref}
    >
      <circle class={css["chosen-reach"]} r={22} />
      <circle class={css["chosen-ring"]} r={10} />
    </g>
  );
}

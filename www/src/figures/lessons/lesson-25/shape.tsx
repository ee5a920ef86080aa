import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { EXACT, VerdictChip, Why } from "../../kit/frame/verdict";
import { Plane } from "../../kit/locus/locus-square";
import { BOUNDS, mapsOf } from "../../kit/locus/set-m";
import { boxAround } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";
import { useVerdict } from "../../kit/workers";
import lessonCss from "../frame/lesson.module.css";
import { onCircle } from "./walk";
import css from "./walk.module.css";

/** The shape at a place of a circle, and what is known of it. */
export function useShape(size: number, degrees: number) {
  const maps = useMemo(() => mapsOf(onCircle(size, degrees)), [size, degrees]);
  const judged = useVerdict(maps, EXACT);
  return { maps, answer: judged?.maps === maps ? judged.answer : null, judged };
}

interface WalkProps {
  size: number;
  degrees: number;
  range?: readonly [number, number];
  onDegrees: (degrees: number) => void;
}

/** A walk along a circle: where one is, the shape there, and the verdict. */
export function Walk({ size, degrees, range = [0, 90], onDegrees }: WalkProps) {
  const { maps, judged } = useShape(size, degrees);
  const box = useMemo(() => boxAround([maps]), [maps]);
  const words = `The shape of size ${fixed(size)} and angle ${degrees} degrees`;
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Picture
        maps={maps}
        box={box}
        label={`${words}: ${verdictPhrase(judged?.maps === maps ? judged.answer : null, EXACT)}.`}
      />
      <div class={lessonCss["ask"]}>
        <Circle size={size} degrees={degrees} />
        <SliderControl
          label="angle of"
          symbol="s"
          name="Angle of s"
          range={range}
          whole
          value={degrees}
          text={`${degrees}°`}
          valueText={`${degrees} degrees`}
          onChange={onDegrees}
        />
        <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} stale={judged?.maps !== maps} />
        <Why answer={judged?.answer} />
      </div>
    </div>
  );
}

/** The plane of s with the circle and the walker on it. */
function Circle({ size, degrees }: { size: number; degrees: number }) {
  return (
    <div class={css["circle"]}>
      <Plane field={null} bounds={BOUNDS} plain label={null} point={onCircle(size, degrees)}>
        {(place) => {
          const [x, y] = place([0, 0]);
          return (
            <g>
              <path d={`M0 ${y}H300M${x} 0V300`} />
              <circle cx={x} cy={y} r={place([size, 0])[0] - x} />
            </g>
          );
        }}
      </Plane>
    </div>
  );
}

import { fixed } from "#format/numbers";
import type { MapRow } from "#wasm/api";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { mapsAt } from "../../kit/maps/morphs";
import { whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { flagPath, leastScale, stopHolds, turned } from "./flag";
import flagCss from "./flag.module.css";

const RADIAN = Math.PI / 180;
const SCALE = 0.5;
const FRAMES = 7;

/** The letter at even times on a way of turns, from the first to the last, number by number between two. */
function along(degrees: readonly number[]): MapRow[] {
  const stretches = degrees.length - 1;
  return Array.from({ length: FRAMES }, (_, i) => {
    const at = (stretches * i) / (FRAMES - 1);
    const from = Math.min(stretches - 1, Math.floor(at));
    const [a = 0, b = 0] = degrees.slice(from, from + 2);
    const ends = { from: [turned(a * RADIAN, SCALE)], to: [turned(b * RADIAN, SCALE)] };
    return mapsAt(ends, [at - from, at - from], "linear")[0] ?? [0, 0, 0, 0, 0, 0];
  });
}

function Letters({ degrees, label }: { degrees: readonly number[]; label: string }) {
  return (
    <svg class={flagCss["flags"]} viewBox={`0 0 ${70 * FRAMES} 70`} role="img" aria-label={label}>
      {along(degrees).map((map, i) => (
        <g key={`${i + 1}`} transform={`translate(${70 * i + 35} 35)`}>
          <circle r={33} class={flagCss["flag-ring"]} />
          <path class={flagCss["flag"]} d={flagPath(map, 52)} />
        </g>
      ))}
    </svg>
  );
}

export function Halved() {
  const [angle, setAngle] = useKept("x1.angle", 60, whole(0, 180));
  const least = leastScale(angle * RADIAN);
  return (
    <Exercise
      number={1}
      ask="Choose the turn that the letter begins with, so that number by number it is exactly half as large half-way: half as tall, and half as wide."
      hints={[
        "Half-way lies the middle of a straight line between two points of a circle. How far is it from the centre?",
        "The middle is nearer to the centre the wider the angle between the two points. Draw the triangle of the centre and the two points, and halve it.",
        "A right triangle with one side half as long as the longest has an angle of 60 degrees. That is half of the turn.",
      ]}
      solved={Math.abs(least - 0.5) < 1e-9}
      status={`A turn of ${angle}°: half-way it is ${fixed(least)} times as large.`}
    >
      <Letters
        degrees={[angle, 0]}
        label={`A letter turned by ${angle} degrees and back, number by number.`}
      />
      <div class={layout["controls"]}>
        <Turned label="turn at the beginning" value={angle} onChange={setAngle} />
      </div>
    </Exercise>
  );
}

export function Stopped() {
  const [angle, setAngle] = useKept("x2.angle", 150, whole(0, 180));
  const least = Math.min(leastScale((180 - angle) * RADIAN), leastScale(angle * RADIAN));
  return (
    <Exercise
      number={2}
      ask="The letter is upside down again, a turn of 180°, but now with one stop on the way, where it is turned by an angle that you choose. Between the stops it goes number by number. It must never be less than 0.7 times as large as it was."
      hints={[
        "Each part of the way makes it smaller in its own middle, and the wider turn makes it smaller by more.",
        "Make both turns the same.",
      ]}
      solved={stopHolds(angle)}
      status={`Stop at ${angle}°: the least it is on the way is ${fixed(least, 3)} times as large.`}
    >
      <Letters
        degrees={[180, angle, 0]}
        label={`A letter turned by 180 degrees, then by ${angle}, then upright, number by number between them.`}
      />
      <div class={layout["controls"]}>
        <Turned label="turn at the stop" value={angle} onChange={setAngle} />
      </div>
    </Exercise>
  );
}

interface TurnedProps {
  label: string;
  value: number;
  onChange: (degrees: number) => void;
}

function Turned({ label, value, onChange }: TurnedProps) {
  return (
    <SliderControl
      label={label}
      range={[0, 180]}
      whole
      value={value}
      text={`${value}°`}
      valueText={`${value} degrees`}
      onChange={onChange}
    />
  );
}

import { useMemo } from "preact/hooks";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { bufferOf, Pixels, seemsIn } from "./seen";

/** The scale at which pieces touch, and one at which they are a twenty-fifth of the side apart. */
const [TOUCHING, APART] = [0.5, 0.48];

const words = (count: number) => (count === 1 ? "in one piece" : `in ${count} pieces`);

/** A picture may also part what touches. */
export function OtherWay() {
  const [size, setSize] = useKept("x1.size", 15, whole(1, 99));
  const count = useMemo(() => seemsIn(bufferOf(TOUCHING, size)), [size]);
  return (
    <Exercise
      number={1}
      ask="Here the scale is exactly ½, so the pieces touch and the shape is in one piece. Find a number of pixels with which the picture says that it is in pieces."
      hints={[
        "Pieces 1 and 2 touch in the middle of the lower side. What lies in the middle of the picture, a pixel or a line between two?",
        "Try an even number.",
      ]}
      solved={count > 1}
      status={`With ${size} pixels a side it seems to be ${words(count)}.`}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <div>
          <Pixels r={TOUCHING} size={size} />
        </div>
        <Fineness range={[7, 45]} step={1} value={size} onChange={setSize} />
      </div>
    </Exercise>
  );
}

/** More pixels may say less. */
export function NotBetter() {
  const [size, setSize] = useKept("x2.size", 15, whole(1, 99));
  const [one, more] = useMemo(
    () => [size, size + 2].map((side) => seemsIn(bufferOf(APART, side))) as [number, number],
    [size],
  );
  return (
    <Exercise
      number={2}
      ask="Now the scale is 0.48, and the three pieces are apart. Find an odd number of pixels with which the picture is right, though with two pixels more it is wrong again and says that all is one piece."
      hints={[
        "The gap is a twenty-fifth of the side. So look where a pixel is about as wide as that.",
        "Look between 23 and 31.",
      ]}
      solved={one === 3 && more === 1}
      status={`With ${size} pixels a side it seems to be ${words(one)}, with ${size + 2} ${words(more)}.`}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Pixels r={APART} size={size} />
        <Pixels r={APART} size={size + 2} />
      </div>
      <div class={layout["controls"]}>
        <Fineness range={[7, 45]} step={2} value={size} onChange={setSize} />
      </div>
    </Exercise>
  );
}

interface FinenessProps {
  range: readonly [number, number];
  step: number;
  value: number;
  onChange: (size: number) => void;
}

function Fineness({ range, step, value, onChange }: FinenessProps) {
  return (
    <SliderControl label="pixels a side" range={range} step={step} whole value={value} onChange={onChange} />
  );
}

import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { number, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { dustDimension } from "./size";

export function Exercises() {
  return (
    <>
      <HalfWay />
      <InSpace />
    </>
  );
}

/** A dust that is half-way between a line and a plane. */
function HalfWay() {
  const [size, setSize] = useKept("x1.size", 0.4, number(0.3, 0.74, 2));
  const d = dustDimension(size);
  return (
    <Exercise
      number={1}
      ask="A dust of two pieces has dimension 1.5, half-way between a line and the plane. How large are its pieces? Find the size to two digits."
      hints={[
        "At ½ the dimension is 1, and at 0.7071 it is 2.",
        "2 · |s| to the power of 1.5 is 1. So |s| to the power of 1.5 is ½, and |s| to the power of 3 is ¼.",
      ]}
      solved={Math.abs(size - 0.63) < 1e-9}
      status={`2 pieces of size ${fixed(size)}: dimension ${fixed(d, 3)}.`}
    >
      <Size value={size} onChange={setSize} />
    </Exercise>
  );
}

const PIECES = 2;
const SPACE = 3;
/** Half to the power of a third. */
const LARGEST = (1 / PIECES) ** (1 / SPACE);

/** The same bound for shapes of space. */
function InSpace() {
  const [percent, setPercent] = useKept("x2.percent", 60, whole(30, 95));
  const size = percent / 100;
  const d = dustDimension(size);
  const solved = d > SPACE && (percent - 1) / 100 < LARGEST;
  return (
    <Exercise
      number={2}
      ask="In space nothing has more than dimension 3. From which size on can a shape of two pieces in space no longer be dust? Find the least hundredth for which that is sure."
      hints={[
        "Ask for which size the dimension would be 3.",
        "2 · |s|³ = 1: |s| is the number whose third power is ½.",
      ]}
      solved={solved}
      status={`2 pieces of size ${fixed(size)}: a dust would have dimension ${fixed(d, 3)}${
        d > SPACE
          ? solved
            ? ", more than there is room for."
            : "; but less would do."
          : ", for which there is room."
      }`}
    >
      <Size value={size} most={0.95} onChange={(next) => setPercent(Math.round(100 * next))} />
    </Exercise>
  );
}

interface SizeProps {
  value: number;
  most?: number;
  onChange: (size: number) => void;
}

function Size({ value, most = 0.74, onChange }: SizeProps) {
  return (
    <div class={layout["controls"]}>
      <SliderControl
        label="size of"
        symbol="s"
        name="Size of s"
        range={[0.3, most]}
        step={0.01}
        value={value}
        onChange={(next) => onChange(Number(next.toFixed(2)))}
      />
    </div>
  );
}

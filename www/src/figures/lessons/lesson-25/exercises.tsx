import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { number, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import { useShape, Walk } from "./shape";
import { ASKED } from "./walk";

export function Exercises() {
  return (
    <>
      <LastWhole />
      <HowFarOut />
    </>
  );
}

/** Above this angle none of the whole degrees of the circle is proved in one piece. */
const LAST = 81;

function LastWhole() {
  const [degrees, setDegrees] = useKept("x1.angle", 66, whole(0, 90));
  const { answer } = useShape(ASKED, degrees);
  const isWhole = answer?.verdict === "connected";
  return (
    <Exercise
      number={1}
      ask={`On the circle of size ${ASKED}, which is the largest whole angle at which the shape is proved in one piece?`}
      hints={[
        "At 90° it is dust. Walk back from there.",
        "There is a bay of dust before it: the first piece that you meet from 66° on is not the last.",
      ]}
      solved={answer && isWhole && degrees === LAST}
      status={
        answer === null
          ? "Looking …"
          : isWhole
            ? degrees === LAST
              ? `In one piece at ${LAST}°, and dust from ${LAST + 1}° on.`
              : "In one piece; but there is a larger angle."
            : answer.verdict === "disconnected"
              ? "Dust."
              : "Here nothing is proved."
      }
    >
      <Walk size={ASKED} degrees={degrees} onDegrees={setDegrees} />
    </Exercise>
  );
}

const ANGLE = 90;

/** Straight up the edge is reached at the last moment only. */
function HowFarOut() {
  const [size, setSize] = useKept("x2.size", 0.6, number(0.5, 0.74, 3));
  const { answer } = useShape(size, ANGLE);
  const isWhole = answer?.verdict === "connected";
  const solved = answer && isWhole && size < 0.7081;
  return (
    <Exercise
      number={2}
      ask="Now stay at 90°, and go outwards. How small can the size be, in steps of 0.001, and the shape be proved in one piece?"
      hints={[
        "Turn by a quarter, twice: then s · s is a real number below 0. Its size is the square of that of s.",
        "The shape is made of two dusts on lines, one across and one up, of scale |s|². They close at ½.",
      ]}
      solved={solved}
      status={
        answer === null
          ? "Looking …"
          : `At ${fixed(size, 3)} it is ${isWhole ? (solved ? "in one piece: its square is just above ½" : "in one piece; but it may be smaller") : answer.verdict === "disconnected" ? "dust" : "not proved to be either"}.`
      }
    >
      <div class={layout["controls"]}>
        <SliderControl
          label="size of"
          symbol="s"
          name="Size of s"
          range={[0.5, 0.74]}
          step={0.001}
          value={size}
          text={fixed(size, 3)}
          onChange={(next) => setSize(Number(next.toFixed(3)))}
        />
      </div>
    </Exercise>
  );
}

import { fixed } from "#format/numbers";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { list, whole } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import lessonCss from "../frame/lesson.module.css";
import { Curve } from "./curve";
import { dimension, isQuarter, spares, total } from "./rough";

type Points = { heights: readonly number[] };

export function Half({ heights }: Points) {
  const [percent, setPercent] = useKept("x1.percent", 30, whole(0, 95));
  const s = percent / 100;
  const curve = { heights: [heights[0] ?? 0, heights[1] ?? 0, heights[2] ?? 0], factors: [s, s] };
  return (
    <Exercise
      number={1}
      ask="Now only three points, so two pieces. Choose the roughness so that the dimension lies between 1.23 and 1.27."
      hints={[
        "With two pieces the roughnesses sum to 2s, and the dimension is 1 + log(2s) / log 2.",
        "So 2s must be near 2 to the power of ¼, which is 1.19.",
      ]}
      solved={isQuarter(curve)}
      status={`Both roughnesses sum to ${fixed(2 * s)}: dimension ${fixed(dimension(curve), 3)}.`}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Curve curve={curve} label={`A curve through three points with roughness ${fixed(s)}.`} />
        <SliderControl
          label="roughness"
          symbol="s"
          range={[0, 95]}
          whole
          value={percent}
          text={fixed(s)}
          onChange={setPercent}
        />
      </div>
    </Exercise>
  );
}

export function Sparing({ heights }: Points) {
  const [percents, setPercents] = useKept<readonly number[]>(
    "x2.percents",
    [40, 40, 40, 40],
    list(whole(-95, 95), 4, 4),
  );
  const curve = { heights, factors: percents.map((percent) => percent / 100) };
  const straight = percents.filter((percent) => percent === 0).length;
  return (
    <Exercise
      number={2}
      ask="Each piece has a roughness of its own now; one below 0 turns its copy upside down. Leave as many pieces straight as you can, with roughness 0, and still have a dimension above 1.2."
      hints={[
        "The dimension asks only for the sum of the sizes, and not which piece has how much. A minus does not count.",
        "For 1.2 the sum must be above 4 to the power of 0.2, which is 1.32. How many pieces of less than 1 does that take?",
      ]}
      solved={spares(curve)}
      status={`${straight} of 4 straight. The sizes sum to ${fixed(total(curve.factors))}: dimension ${fixed(dimension(curve), 3)}.`}
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Curve
          curve={curve}
          label={`The curve with roughnesses ${curve.factors.map((factor) => fixed(factor)).join(", ")}.`}
        />
        <div class={lessonCss["ask"]}>
          {percents.map((percent, i) => (
            <SliderControl
              key={`${i + 1}`}
              label={`roughness of piece ${i + 1}`}
              range={[-95, 95]}
              step={5}
              whole
              value={percent}
              text={fixed(percent / 100)}
              onChange={(next) => setPercents(percents.with(i, next))}
            />
          ))}
        </div>
      </div>
    </Exercise>
  );
}

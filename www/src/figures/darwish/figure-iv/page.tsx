import { useMemo, useState } from "preact/hooks";
import { fixed } from "#format/numbers";
import { about3, after3, scale3, turns3 } from "#geometry/maps/affine3";
import { Button } from "#ui/controls/Button";
import type { MapRow3 } from "#wasm/api";
import { loadSpace, solid } from "#wasm/space";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { tex } from "../../kit/notation/tex";
import { whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { fromOrigin, VIEW } from "../space/eye";
import { LookAgain } from "../space/look-again";
import { PRINTED_MIDDLE, printedTriangle } from "../space/shapes";
import { inSpaceTool } from "../space/tool-link";
import { ANGLES, AngleSliders, type Angles, Conjugated, inRadians } from "../space/turning";

const STILL = scale3([1, 1, 1]);
const MOST_TURNS = 10_999;
/** From the origin, as in the paper. */
const HOME = fromOrigin(PRINTED_MIDDLE, 0.045);

interface Course {
  step: MapRow3;
  times: number;
  now: MapRow3[];
  /** The same turns, done to points. */
  by: MapRow3;
}

/** Goes on by some turns, each of them a conjugation of what the last has left. */
function onward(course: Course, times: number): Course {
  let { now, by } = course;
  for (let i = 0; i < times; i++) {
    now = solid.conjugate3(now, course.step);
    by = after3(course.step, by);
  }
  return { ...course, times: course.times + times, now, by };
}

/** What stands in its address. */
export const STATE = {
  angles: kept<Angles>([7, 11, 13], ANGLES),
  turns: kept(0, whole(0, MOST_TURNS)),
  // `view` stood in addresses while the triangle was another one, and lay elsewhere.
  seen: kept(HOME, VIEW),
};

/** What must be there before it is shown. */
export const needs = [loadSpace];

/** The triangle that is printed whole. Turned again and again: what rounding does to parameters of parameters. */
export function Page(heading: Heading) {
  const made = useMemo(printedTriangle, []);
  const [angles, setAngles] = useKept("angles", ...STATE.angles);
  const start = (next: Angles, times: number) =>
    onward({ step: about3(turns3(inRadians(next)), PRINTED_MIDDLE), times: 0, now: made, by: STILL }, times);
  const [turns, setTurns] = useKept("turns", ...STATE.turns);
  const [course, setCourse] = useState(() => start(angles, turns));
  const go = (next: Course) => {
    setCourse(next);
    setTurns(next.times);
  };
  const [view, setView] = useKept("seen", ...STATE.seen);
  return (
    <Frame
      {...heading}
      lead={
        <p>
          These parameters are printed whole, and the eye at the origin sees this. An animation turns what was
          turned already, frame after frame, and never goes back to how the shape was made. Do it: each press
          takes the parameters as they are and conjugates them once more. How long does that go well?
        </p>
      }
      found={
        <p>
          After thousands of turns the two ways still agree to nine digits and more: errors of rounding add
          up, but they do not grow by themselves. Frond does not let even these add up: it keeps each shape as
          it was made, and all that was done to it in one transform, so that undoing it is exact.
        </p>
      }
      parameters={[
        { name: "Turns so far", value: course.times.toLocaleString("en") },
        ...(["x", "y", "z"] as const).map((axis, k) => ({
          name: `Each about ${axis}`,
          value: `${fixed(angles[k] ?? 0, 0)}°`,
        })),
        { name: "Matrix of each map", symbol: "A", value: [tex`\operatorname{diag}(0.5, 0.5, 0.5)`] },
        {
          name: "Translations as printed",
          symbol: "b",
          value: "(15.07, 0.05, −0.02), (15.34, 0.03, 0.25), (15.38, 0.32, 0.16)",
        },
        { name: "Corners", value: "twice as far away" },
        { name: "What stays", value: `(${PRINTED_MIDDLE.join(", ")}), its middle` },
        { name: "Eye", value: "(0, 0, 0), looking at the middle" },
      ]}
      captions={["Fig iv (After more rotations)"]}
      reconstructed={null}
      differs="How wide the picture is, is not printed. The further turns, their angles and the point that stays are Frond’s."
      studio={inSpaceTool([{ name: "Triangle", maps: made, moved: course.by }], view)}
    >
      <Conjugated
        made={made}
        by={course.by}
        now={course.now}
        view={view}
        onView={setView}
        label={`The printed triangle after ${course.times} turns`}
      >
        <div class={layout["buttons"]}>
          {[1, 100, 1000].map((times) => (
            <Button
              key={times}
              disabled={course.times + times > MOST_TURNS}
              onClick={() => go(onward(course, times))}
            >
              {times === 1 ? "Turn once more" : `${times.toLocaleString("en")} times`}
            </Button>
          ))}
          <Button
            kind="quiet"
            icon="reset"
            disabled={course.times === 0}
            onClick={() => go(start(angles, 0))}
          >
            As printed
          </Button>
          <LookAgain view={view} home={HOME} onView={setView} />
          <span class={layout["choice-label"]} role="status">
            {course.times.toLocaleString("en")} {course.times === 1 ? "turn" : "turns"} so far
          </span>
        </div>
        <AngleSliders
          angles={angles}
          onChange={(next) => {
            setAngles(next);
            go(start(next, Math.min(course.times, 40)));
          }}
        />
      </Conjugated>
    </Frame>
  );
}

import { useMemo } from "preact/hooks";
import { dark } from "#document/preferences";
import { fixed } from "#format/numbers";
import { palette } from "#style/palette";
import { Switch } from "#ui/controls/Switch";
import type { MapRow } from "#wasm/api";
import { Choice, SliderControl } from "../../kit/frame/control";
import type { Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { preset, studioHref } from "../../kit/frame/studio-link";
import { fixedPoint } from "../../kit/maps/families";
import { boxAround } from "../../kit/maps/morphs";
import { apply, type Point } from "../../kit/maps/pieces";
import { Drawn } from "../../kit/picture/annotated";
import { Picture } from "../../kit/picture/picture";
import { flag, list, number, text } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { useValue } from "../../kit/workers";
import { ChoiceQuestion } from "../frame/choice-question";
import { Exercise } from "../frame/exercise";
import { Lesson } from "../frame/lesson";
import lessonCss from "../frame/lesson.module.css";
import { type Prediction, useChoice } from "../frame/prediction";
import { chosen, lean, leaning, PARTS } from "./maps";
import css from "./page.module.css";
import { TEACHING } from "./teaching";

const EVERY = PARTS.map(() => true);

/** Barnsley's fern. */
export function Page(heading: Heading) {
  const prediction = useChoice<Lost>(OPTIONS);
  const fern = useMemo(() => preset("fern"), []);
  return (
    <Lesson
      {...heading}
      text={
        <>
          <p>
            This fern is four smaller copies of itself: a tall one that is all but the lowest pair of leaves,
            the lowest leaf on each side, and the stem, which is the whole fern pressed into a line. Nothing
            else is stored: four maps of six numbers each.
          </p>
          <p>
            <span data-screen="">Switch the copies off and on. </span>
            The frame of each is the frame of the whole, put where its map puts it.
          </p>
        </>
      }
      question={<Stem fern={fern.maps} prediction={prediction} />}
      exercises={
        <>
          <Missing fern={fern.maps} />
          <Straight fern={fern.maps} />
        </>
      }
      teaching={TEACHING}
      parameters={fern.maps.map((map, i) => ({
        name: `Map ${i + 1}, ${PARTS[i]}`,
        value: map.join(", "),
      }))}
      sources={
        <p>
          Michael Barnsley, <cite>Fractals Everywhere</cite> (1988); the numbers are those of his black
          spleenwort. A map takes (x, y) to (a x + b y + e, c x + d y + f), and stands in the list as a, b, c,
          d, e, f.
        </p>
      }
      // The fern alone: its maps are there to be changed.
      studio={{ href: studioHref({ a: fern, b: fern }) }}
    >
      <Switched fern={fern.maps} />
    </Lesson>
  );
}

interface FernProps {
  fern: MapRow[];
}

const useFrame = (maps: MapRow[]) => useMemo(() => boxAround([maps]), [maps]);

/** Each copy with its frame, to be switched off. */
function Switched({ fern }: FernProps) {
  const [on, setOn] = useKept<readonly boolean[]>("on", EVERY, list(flag, PARTS.length, PARTS.length));
  const { maps, hues } = useMemo(() => chosen(fern, on), [fern, on]);
  const colours = palette(useValue(dark) ? "dark" : "light");
  const box = useFrame(fern);
  const corners: Point[] = [
    [box.x0, box.y0],
    [box.x1, box.y0],
    [box.x1, box.y1],
    [box.x0, box.y1],
  ];
  const left = PARTS.filter((_, i) => !on[i]);
  const single = maps.length === 1 ? maps[0] : undefined;
  return (
    <div class={`${layout["two-columns"]} ${layout["even"]}`}>
      <Drawn
        maps={maps}
        hues={hues}
        box={box}
        label={
          left.length === 0
            ? "Barnsley’s fern, with the frames of its four copies."
            : `The fern without ${left.join(", ")}.`
        }
      >
        {(place) => (
          <>
            {fern.map(
              (map, i) =>
                on[i] && (
                  <path
                    key={PARTS[i]}
                    class={css["frame"]}
                    d={`M${around(corners.map((corner) => place(apply(map, corner)))).join("L")}Z`}
                  />
                ),
            )}
            {single && <SinglePoint at={place(fixedPoint(single))} colour={colours[hues[0] ?? 0]} />}
          </>
        )}
      </Drawn>
      <div class={lessonCss["ask"]}>
        {PARTS.map((part, i) => (
          <Switch
            key={part}
            checked={on[i] ?? true}
            // Without any map there is no shape.
            disabled={on[i] === true && maps.length === 1}
            onChange={(next) => setOn(on.map((was, k) => (k === i ? next : was)))}
          >
            <i class={css["swatch"]} style={{ background: colours[i] }} /> Map {i + 1}: {part}
          </Switch>
        ))}
        <p class={layout["hint"]} aria-live="polite">
          {maps.length === 1
            ? "One map alone makes a single point, here in the ring: the one that it leaves in place."
            : left.length === 0
              ? "All four: the fern."
              : `Switched off: ${left.join(" and ")}.`}
        </p>
      </div>
    </div>
  );
}

/** The corners of a frame; a frame that is pressed into a line stands around the line, not over it. */
function around(corners: readonly Point[]): string[] {
  const [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  if (Math.min(right - left, bottom - top) > 2 * BESIDE) return corners.map(([x, y]) => `${x} ${y}`);
  const [x0, x1, y0, y1] = [left - BESIDE, right + BESIDE, top - BESIDE, bottom + BESIDE];
  return [`${x0} ${y0}`, `${x1} ${y0}`, `${x1} ${y1}`, `${x0} ${y1}`];
}

/** How far such a frame stays off its line, in 400ths of the picture's width. */
const BESIDE = 4;

/** What would be seen of a shape that is one point: hardly anything. */
function SinglePoint({ at: [x, y], colour }: { at: Point; colour: string | undefined }) {
  return (
    <>
      <circle cx={x} cy={y} r={3} fill={colour} />
      <circle class={css["ring"]} cx={x} cy={y} r={9} />
    </>
  );
}

type Lost = "bit" | "all" | "nothing" | "leaves";
const OPTIONS = [
  {
    value: "bit",
    label: "The lowest bit of the stem, nothing else",
    wrong:
      "It is that bit that map 1 draws in the whole. But every leaf is a copy of the whole: look at the stalks of the leaves now.",
  },
  { value: "all", label: "Every stem: that of the fern, of each leaf, and of each leaflet on it" },
  {
    value: "nothing",
    label: "Nothing: the other maps draw the fern",
    wrong: "The others make copies of what there is. Without a stem in the whole no copy has one.",
  },
  {
    value: "leaves",
    label: "The leaves fall: nothing holds them",
    wrong: "Where a leaf goes is said by its own map, and that is as before.",
  },
] as const;

function Stem({ fern, prediction }: FernProps & { prediction: Prediction<Lost> }) {
  const { shown } = prediction;
  const bare = useMemo(() => chosen(fern, [false, true, true, true]), [fern]);
  const box = useFrame(fern);
  return (
    <ChoiceQuestion<Lost>
      prediction={prediction}
      ask="Map 1 makes the stem: the whole fern, pressed into a short line at the bottom. What does the fern lose when it is left out?"
      options={OPTIONS}
      truth="all"
      beside={
        <Picture
          maps={shown ? bare.maps : fern}
          hues={shown ? bare.hues : undefined}
          box={box}
          label={shown ? "The fern without its first map: no stem anywhere." : "Barnsley’s fern."}
        />
      }
      line="All stems are gone, down to the smallest."
    >
      <p>
        The shape is made of its copies, and each copy of copies in turn. What a map does in the whole it does
        in every leaf, in every leaflet, and so on without end. One map is one feature at all sizes.
      </p>
    </ChoiceQuestion>
  );
}

const WHICH = [2, 3, 4] as const;
/** Which one is missing: not the first that one tries. */
const GONE = 4;

function Missing({ fern }: FernProps) {
  const [said, setSaid] = useKept("x1.missing", "0", text(/[0-4]/));
  const { maps, hues } = useMemo(
    () =>
      chosen(
        fern,
        fern.map((_, i) => i !== GONE - 1),
      ),
    [fern],
  );
  const box = useFrame(fern);
  return (
    <Exercise
      number={1}
      ask="One map of this fern has been left out. Which?"
      hints={[
        "Compare the lowest leaves, and then the leaflets of one leaf.",
        "Switch them off one by one above.",
      ]}
      solved={Number(said) === GONE}
      status={
        said === "0"
          ? "Choose a map."
          : Number(said) === GONE
            ? `Map ${said} makes ${PARTS[GONE - 1]}; and each leaf has leaflets on one side only.`
            : `Map ${said} makes ${PARTS[Number(said) - 1]}: that is there.`
      }
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Picture
          maps={maps}
          hues={hues}
          box={box}
          label="A fern that has leaves on one side only, and so have its leaves."
        />
        <Choice
          label="Missing"
          name="Which map is missing"
          options={WHICH.map((map) => ({ value: String(map), label: `map ${map}` }))}
          value={said}
          onChange={setSaid}
        />
      </div>
    </Exercise>
  );
}

function Straight({ fern }: FernProps) {
  const [degrees, setDegrees] = useKept("x2.lean", Math.round(2 * lean(fern)) / 2, number(-12, 12, 1));
  const maps = useMemo(() => leaning(fern, degrees), [fern, degrees]);
  const box = useFrame(maps);
  return (
    <Exercise
      number={2}
      ask="The fern bends to the right, as its large map turns a little. Turn it so that the fern grows straight up."
      hints={[
        "What turns each copy of a copy a little more bends the whole.",
        "How much may it turn if nothing is to bend?",
      ]}
      solved={degrees === 0}
      status={
        degrees === 0
          ? "Each copy stands upright in the one before it."
          : `Each pair of leaves is turned by ${fixed(Math.abs(degrees), 1)}° against the one below it, to the ${degrees > 0 ? "right" : "left"}.`
      }
    >
      <div class={`${layout["two-columns"]} ${layout["even"]}`}>
        <Picture
          maps={maps}
          box={box}
          label={`The fern with its large map turned by ${fixed(degrees, 1)} degrees.`}
        />
        <SliderControl
          label="turn of map 2"
          range={[-12, 12]}
          step={0.5}
          value={degrees}
          text={`${fixed(degrees, 1)}°`}
          valueText={`${fixed(degrees, 1)} degrees`}
          onChange={(next) => setDegrees(Math.round(2 * next) / 2)}
        />
      </div>
    </Exercise>
  );
}

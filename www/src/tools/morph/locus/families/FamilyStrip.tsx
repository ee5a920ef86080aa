import { verdict } from "#compute/results";
import { here } from "#document/morph";
import { endGesture } from "#document/scene";
import { complexWords } from "#format/parameters";
import { verdictPhrase } from "#format/verdict";
import { Slider } from "#ui/controls/Slider";
import { narrow } from "#ui/media";
import { PlayButton } from "#ui/strip/PlayButton";
import css from "../field.module.css";
import * as messages from "../messages";
import { sides } from "../view/view";
import { Courses } from "./Courses";
import { courseOf, STEPS } from "./course";
import { orbitBreaks, orbiting, orbitTo, place, toggleOrbit } from "./orbit";

const WORDS = {
  round: {
    where: messages.onCircleAround,
    label: messages.angleSAround0,
    value: (part: number) => messages.degrees(Math.round(360 * part)),
  },
  ray: {
    where: messages.onRayFrom0,
    label: messages.sizeS,
    value: (part: number) => `${Math.round(100 * part)}%`,
  },
  spiral: {
    where: messages.onSpiralInto,
    label: messages.stepsSIntoLandmark,
    value: (part: number) => messages.stepOf((STEPS * part).toFixed(1), STEPS),
  },
};

/** What takes the place of the morph's time, where the map is a family's: s on its way. */
export function FamilyStrip() {
  const words = WORDS[courseOf(sides.value)];
  const known = verdict.value;
  const told = known && !known.stale ? `, ${verdictPhrase(known.connectedness)}` : "";
  return (
    <section class="strip" aria-label={messages.pathS}>
      <PlayButton playing={orbiting.value} onToggle={toggleOrbit} />
      <div class={css["family-way"]}>
        <p class="number">
          {messages.sIs(complexWords(here.value, 3))}
          {!narrow.value && <span class="dim"> {words.where}</span>}
        </p>
        <Slider
          label={words.label}
          value={place.value}
          step={0.005}
          valueText={`${words.value(place.value)}${told}`}
          onChange={orbitTo}
          onDone={endGesture}
        >
          {orbitBreaks.value.map(({ t0, t1 }) => (
            <span
              key={`${t0}-${t1}`}
              class={css["family-break"]}
              style={{ left: `${100 * t0}%`, width: `max(2px, ${100 * (t1 - t0)}%)` }}
            />
          ))}
        </Slider>
      </div>
      {!narrow.value && <Courses />}
    </section>
  );
}

import { verdict } from "#compute/results";
import { here } from "#document/morph";
import { endGesture } from "#document/scene";
import { complexWords } from "#format/parameters";
import { verdictPhrase } from "#format/verdict";
import { Slider } from "#ui/controls/Slider";
import { narrow } from "#ui/media";
import { PlayButton } from "#ui/strip/PlayButton";
import css from "../field.module.css";
import { Courses } from "./Courses";
import { course } from "./course";
import { orbitBreaks, orbiting, orbitTo, place, toggleOrbit } from "./orbit";

/** What takes the place of the morph's time, where the map is a family's: s on its way. */
export function FamilyStrip() {
  const round = course.value === "round";
  const known = verdict.value;
  const told = known && !known.stale ? `, ${verdictPhrase(known.connectedness)}` : "";
  return (
    <section class="strip" aria-label="The way of s">
      <PlayButton playing={orbiting.value} onToggle={toggleOrbit} />
      <div class={css["family-way"]}>
        <p class="number">
          s = {complexWords(here.value, 3)}
          {!narrow.value && <span class="dim"> {round ? "on the circle about 0" : "on the ray from 0"}</span>}
        </p>
        <Slider
          label={round ? "Turn of s about 0" : "Size of s"}
          value={place.value}
          step={0.005}
          valueText={`${round ? `${Math.round(360 * place.value)} degrees` : `${Math.round(100 * place.value)}%`}${told}`}
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

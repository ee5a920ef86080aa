import { MOST_ZOOM } from "#compute/locus/window";
import { here } from "#document/morph";
import { lowered } from "#format/parameters";
import { powerWords } from "#format/verdict";
import { Button } from "#ui/controls/Button";
import { narrow } from "#ui/media";
import fieldCss from "../field.module.css";
import * as messages from "../messages";
import { fly, pickPoint, sides } from "../view/view";
import { Courses } from "./Courses";
import { centre } from "./course";
import { critical, criticalScale } from "./critical";
import { familyWords, symmetryWords, theoremWords } from "./families";
import { landmarkAt, landmarksOf } from "./landmarks";

/** What others proved of a family, beside what Frond computes, and places to go to. */
export function FamilyNotes() {
  const n = sides.value;
  const all = landmarksOf(n, criticalScale(n));
  const at = landmarkAt(all, here.value);
  return (
    <div class="family-notes">
      <p class="hint">{familyWords(n)}</p>
      {narrow.value && <Courses />}
      <ul class={fieldCss["landmarks"]} aria-label={messages.landmarks}>
        {all.map(({ name, about, s, zoom, spiral }) => (
          <li key={name}>
            <Button
              description={about}
              pressed={at?.name === name}
              onClick={() => {
                if (spiral) centre.value = s;
                pickPoint(s, undefined, MOST_ZOOM);
                fly({ x: s[0], y: s[1], zoom });
              }}
            >
              {name}
            </Button>
          </li>
        ))}
      </ul>
      <div class={fieldCss["landmark-words"]} aria-live="polite">
        {at && (
          <>
            <p>{at.about}.</p>
            <p class="hint">{at.source}.</p>
          </>
        )}
      </div>
      <dl class="critical">
        <div>
          <dt>
            {messages.forRealSShape} <span class="symbol">r{lowered(n)}</span>
          </dt>
          <dd class="number">{criticalScale(n).toFixed(9)}</dd>
          <dd class="hint">{messages.known}</dd>
        </div>
        <div>
          <dt>{messages.computedHere}</dt>
          <Computed />
        </div>
      </dl>
      <ul class="notes">
        {theoremWords(n).map((words) => (
          <li key={words}>{words}</li>
        ))}
        <li>{symmetryWords(n)}</li>
      </ul>
    </div>
  );
}

function Computed() {
  const found = critical.value;
  if (found?.sides !== sides.value) return <dd class="hint">{messages.computing}</dd>;
  return (
    <>
      <dd class="number">{((found.broken + found.holds) / 2).toFixed(9)}</dd>
      <dd class="hint">
        {found.done
          ? messages.plusMinus(powerWords((found.holds - found.broken) / 2))
          : messages.stillComputing}
      </dd>
    </>
  );
}

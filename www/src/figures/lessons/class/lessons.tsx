import { useState } from "preact/hooks";
import { narrow } from "#ui/media";
import { type Lesson, UNITS, type Unit } from "../course";
import css from "./class.module.css";

interface LessonsProps {
  chosen: readonly string[];
  onToggle: (id: string) => void;
}

/** All lessons by their units, to be ticked. Where there is little room, a unit opens when it is pressed. */
export function Lessons(props: LessonsProps) {
  return (
    <div class={css["units"]}>
      {UNITS.map((unit) =>
        narrow.value ? (
          <Folded key={unit.id} unit={unit} {...props} />
        ) : (
          <Open key={unit.id} unit={unit} {...props} />
        ),
      )}
    </div>
  );
}

interface UnitProps extends LessonsProps {
  unit: Unit;
}

function Open({ unit, ...props }: UnitProps) {
  return (
    <fieldset>
      <legend>{unit.title}</legend>
      <Ticks of={unit.figures} {...props} />
    </fieldset>
  );
}

function Folded({ unit: { title, figures }, chosen, onToggle }: UnitProps) {
  const count = figures.filter(({ id }) => chosen.includes(id)).length;
  const [open, setOpen] = useState(count > 0);
  return (
    <details open={open} onToggle={({ currentTarget }) => setOpen(currentTarget.open)}>
      <summary>
        {title}
        {count > 0 && `: ${count} of ${figures.length}`}
      </summary>
      <Ticks of={figures} chosen={chosen} onToggle={onToggle} />
    </details>
  );
}

function Ticks({ of, chosen, onToggle }: LessonsProps & { of: readonly Lesson[] }) {
  return (
    <>
      {of.map(({ id, title, minutes }) => (
        <label key={id} class={css["tick"]}>
          <input type="checkbox" checked={chosen.includes(id)} onChange={() => onToggle(id)} />
          <span>
            {title}{" "}
            <span class={css["minutes"]} aria-hidden="true">
              {minutes} min
            </span>
          </span>
        </label>
      ))}
    </>
  );
}

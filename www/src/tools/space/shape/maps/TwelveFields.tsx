import { useState } from "preact/hooks";
import { NumberField } from "#ui/controls/NumberField";
import { useOwnId } from "#ui/id";
import type { MapRow3 } from "#wasm/api";

export interface TwelveFieldsProps {
  map: MapRow3;
  /** Takes the map, or says why it cannot be; `place` is that of the number that was changed. */
  onChange: (map: MapRow3, place: number) => string | undefined;
  onDone: () => void;
}

const AXES = ["x", "y", "z"] as const;

/** The twelve numbers of a map of space, laid out as the three equations that they are. */
export function TwelveFields({ map, onChange, onDone }: TwelveFieldsProps) {
  const id = useOwnId("twelve");
  const [problems, setProblems] = useState<Record<number, string>>({});
  const field = (place: number, label: string, symbol: string) => (
    <NumberField
      key={place}
      terse
      label={label}
      symbol={symbol}
      value={map[place] ?? 0}
      digits={4}
      onChange={(value) => {
        const next = map.with(place, value) as MapRow3;
        return onChange(next, place);
      }}
      onDone={onDone}
      problems={{
        id,
        tell: (words) =>
          setProblems(({ [place]: _, ...others }) =>
            words === null ? others : { ...others, [place]: words },
          ),
      }}
    />
  );
  return (
    <div class="solid-equations">
      {AXES.map((axis, row) => (
        <div key={axis} class="solid-equation">
          <span class="solid-axis" aria-hidden="true">
            {axis}′ =
          </span>
          {AXES.map((from, column) => field(3 * row + column, `New ${axis} from ${from}`, from))}
          {field(9 + row, `Move along ${axis}`, "+")}
        </div>
      ))}
      <div id={id} role="alert">
        {Object.entries(problems).map(([place, words]) => (
          <p key={place} class="field-problem">
            {words}
          </p>
        ))}
      </div>
    </div>
  );
}

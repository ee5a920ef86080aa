import { pairing } from "../../state/morph";
import { edit, endGesture } from "../../state/scene";
import { NumberField } from "../../ui/NumberField";
import { flatPairs } from "./changes";
import { correspondence, turns } from "./parts";
import { Swatch } from "./shapes/Swatch";
import { listWords } from "./words";

/** What had to be done so that each map has one to become, and what that costs. */
export function PairNotes() {
  const { from, to, steps } = pairing.value;
  const flat = flatPairs(from, to, correspondence.value);
  if (steps.length === 0 && flat.length === 0) return null;
  return (
    <div class="notes">
      {steps.map((step) => (
        <p key={step}>{step}</p>
      ))}
      {flat.length > 0 && (
        <p>
          {flat.length === 1 ? "Map" : "Maps"} {listWords(flat.map(String))}{" "}
          {flat.length === 1 ? "turns over on the way, so it" : "turn over on the way, so each"} must pass
          through a flat state.
        </p>
      )}
    </div>
  );
}

/** Which map becomes which, and by how many whole turns more than the shortest. */
export function PairsPanel() {
  const { from, to } = pairing.value;
  const count = from.length;
  const becomes = correspondence.value.length === count ? correspondence.value : from.map((_, i) => i);
  const extra = turns.value.length === count ? turns.value : from.map(() => 0);

  /** Two maps never become the same one: the other takes what this one leaves. */
  const match = (map: number, target: number) => {
    const next = [...becomes];
    const taken = next.indexOf(target);
    if (taken >= 0) next[taken] = next[map] ?? map;
    next[map] = target;
    edit((before) => ({ ...before, correspondence: next.every((x, i) => x === i) ? [] : next }));
  };
  const turn = (map: number, by: number) => {
    if (!Number.isInteger(by)) return "Whole turns only.";
    const next = extra.map((x, i) => (i === map ? by : x));
    edit((before) => ({ ...before, turns: next.every((x) => x === 0) ? [] : next }), {
      gesture: `turns-${map}`,
    });
    return undefined;
  };

  return (
    <details class="pairs">
      <summary>Which map becomes which</summary>
      <p class="hint">
        Each choice has its own square above: another pairing may hold together where this one breaks.
      </p>
      <ul>
        {from.map((_, map) => (
          <li key={map}>
            <Swatch map={map} />
            <label>
              <span class="unseen">Map {map + 1} </span>becomes{" "}
              <select
                value={String(becomes[map] ?? map)}
                onChange={(event) => match(map, Number(event.currentTarget.value))}
              >
                {to.map((_target, i) => (
                  <option key={i} value={String(i)}>
                    {i + 1}
                  </option>
                ))}
              </select>
            </label>
            <NumberField
              label="extra turns"
              value={extra[map] ?? 0}
              step={1}
              min={-8}
              max={8}
              digits={0}
              onChange={(by) => turn(map, by)}
              onDone={endGesture}
            />
          </li>
        ))}
      </ul>
    </details>
  );
}

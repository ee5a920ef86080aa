import { pairing } from "#document/morph";
import { edit, endGesture } from "#document/scene";
import { NumberField } from "#ui/controls/NumberField";
import { Select } from "#ui/controls/Select";
import { correspondence, turns } from "../document-signals";
import { Swatch } from "../shapes/Swatch";
import { Matching } from "./Matching";
import * as messages from "./messages";
import css from "./pairs.module.css";
import { Routes } from "./Routes";

/** What the fold holds; fetched when it is opened. */
export function PairsDetail() {
  return (
    <>
      <Pairs />
      <Matching />
      <Routes />
    </>
  );
}

/** Each map with what it becomes, and by how many whole turns more than the shortest. */
function Pairs() {
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
    if (!Number.isInteger(by)) return messages.enterWholeNumberTurns;
    const next = extra.map((x, i) => (i === map ? by : x));
    edit((before) => ({ ...before, turns: next.every((x) => x === 0) ? [] : next }), {
      gesture: `turns-${map}`,
    });
    return undefined;
  };

  return (
    <>
      <p class="hint">{messages.eachPairingHasOwn}</p>
      <ul class={css["pairs-list"]}>
        {from.map((_, map) => (
          <li key={map}>
            <Swatch map={map} />
            <label>
              <span class="unseen">{messages.mapNumber(map + 1)} </span>
              {messages.becomes}{" "}
              <Select
                value={String(becomes[map] ?? map)}
                onChange={(event) => match(map, Number(event.currentTarget.value))}
              >
                {to.map((_target, i) => (
                  <option key={i} value={String(i)}>
                    {i + 1}
                  </option>
                ))}
              </Select>
            </label>
            <NumberField
              label={messages.extraTurns}
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
    </>
  );
}

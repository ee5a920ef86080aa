import { changeSpace } from "#document/space/edits";
import { space } from "#document/space/space";
import { matchWords } from "#format/path-words";
import { Select } from "#ui/controls/Select";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { Fold } from "#ui/panel/Fold";
import { HalfTurns } from "#ui/panel/HalfTurns";
import type { Mode } from "#wasm/api";
import { exchanged, flatPairs, inOrder, orderNow, turnedFurther, withMode, withOrder } from "./changes";
import css from "./morph3.module.css";
import { from, halfTurns, morph, nearest } from "./work";

const MODES: readonly { value: Mode; label: string; description: string }[] = [
  { value: "polar", label: "Turned", description: "Polar: turns and stretches of each map go by themselves" },
  { value: "linear", label: "Number by number", description: "Linear: maps may collapse on the way" },
];

/** How maps become maps: which becomes which, and by what way. */
export function Matching() {
  const now = morph.value;
  const maps = from.value;
  const goal = now?.to.maps;
  if (!now || !goal) return null;
  const closest = nearest.value;
  const order = orderNow(now, maps.length);
  const isNearest = order.every((to, i) => to === closest[i]);
  const kind = isNearest ? "nearest" : inOrder(order) ? "order" : "own";
  const flat = now.mode === "linear" ? [] : flatPairs(maps, goal, order);
  return (
    <section class={css["morph3-part"]} aria-label="How maps become maps">
      <ChoiceRow
        label="Maps go"
        name="How maps go"
        value={now.mode ?? "polar"}
        options={MODES}
        onChange={(mode) => changeSpace((before) => withMode(before, mode))}
      />
      <ChoiceRow
        label="Each becomes"
        name="Which map each becomes"
        value={kind}
        options={[
          {
            value: "nearest",
            label: "the nearest",
            description: "Pieces travel, turn and stretch least in all",
          },
          {
            value: "order",
            label: "by number",
            description: inOrder(closest)
              ? "Here these are the nearest, too"
              : "The first the first, and so on",
            disabled: inOrder(closest),
          },
          ...(kind === "own" ? [{ value: "own", label: "as chosen" } as const] : []),
        ]}
        onChange={(next) => {
          if (next === "own") return;
          const list = next === "nearest" ? closest : closest.map((_, i) => i);
          changeSpace((before) => withOrder(before, list));
        }}
      />
      {flat.length > 0 && (
        <p class="notes">
          {flat.length === 1 ? `Map ${flat[0]} reflects` : `Maps ${flat.join(", ")} reflect`} at one end only:
          on the way {flat.length === 1 ? "it" : "they"} must become flat.
        </p>
      )}
      {halfTurns.value.some((turn) => turn !== 0) && (
        <div class="notes">
          <HalfTurns
            other={halfTurns.value}
            onTurn={(by) => changeSpace((before) => turnedFurther(before, by))}
          />
        </div>
      )}
      <Fold title="Map by map" now={matchWords(order, [])}>
        <ol class={css["morph3-order"]}>
          {order.map((to, i) => (
            // Maps have no name but their number.
            <li key={i}>
              <label>
                <span>Map {i + 1} becomes</span>
                <Select
                  value={String(to)}
                  onChange={(event) => {
                    const next = exchanged(order, i, Number(event.currentTarget.value));
                    changeSpace((before) => withOrder(before, next));
                  }}
                >
                  {order.map((_, k) => (
                    <option key={k} value={String(k)}>
                      {k + 1}
                    </option>
                  ))}
                </Select>
              </label>
            </li>
          ))}
        </ol>
        <p class="hint">Two that change partners do so with each other.</p>
      </Fold>
    </section>
  );
}

/** How many objects do not take part. */
export function othersWords(): string {
  const count = (space.value?.objects.length ?? 1) - 1;
  if (count < 1) return "";
  return count === 1
    ? "The other object stays what it is."
    : `The other ${count} objects stay what they are.`;
}

import { changeSpace } from "#document/space/edits";
import { space } from "#document/space/space";
import { matchWords } from "#format/path-words";
import { Select } from "#ui/controls/Select";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import { Fold } from "#ui/panel/Fold";
import { HalfTurns } from "#ui/panel/HalfTurns";
import type { Mode } from "#wasm/api";
import * as messages from "../messages";
import { exchanged, flatPairs, inOrder, orderNow, turnedFurther, withMode, withOrder } from "./morph-edits";
import css from "./morph3.module.css";
import { from, halfTurns, morph, nearest } from "./work";

const MODES: readonly { value: Mode; label: string; description: string }[] = [
  { value: "polar", label: messages.byRotation, description: messages.polarRotationsAndStretches },
  { value: "linear", label: messages.entryByEntry, description: messages.linearMapsMayFlattened },
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
    <section class={css["morph3-part"]} aria-label={messages.howMapsBecomeMaps}>
      <ChoiceRow
        label={messages.blendMaps}
        name={messages.blendMaps}
        value={now.mode ?? "polar"}
        options={MODES}
        onChange={(mode) => changeSpace((before) => withMode(before, mode))}
      />
      <ChoiceRow
        label={messages.pairing}
        name={messages.pairEach}
        value={kind}
        options={[
          {
            value: "nearest",
            label: messages.nearest,
            description: messages.piecesTravelRotateAnd,
          },
          {
            value: "order",
            label: messages.byNumber,
            description: inOrder(closest) ? messages.hereThisAlsoNearest : messages.firstBecomesFirstAnd,
            disabled: inOrder(closest),
          },
          ...(kind === "own" ? [{ value: "own", label: messages.custom3 } as const] : []),
        ]}
        onChange={(next) => {
          if (next === "own") return;
          const list = next === "nearest" ? closest : closest.map((_, i) => i);
          changeSpace((before) => withOrder(before, list));
        }}
      />
      {flat.length > 0 && <p class="notes">{messages.reflects(flat)}</p>}
      {halfTurns.value.some((turn) => turn !== 0) && (
        <div class="notes">
          <HalfTurns
            other={halfTurns.value}
            onTurn={(by) => changeSpace((before) => turnedFurther(before, by))}
          />
        </div>
      )}
      <Fold title={messages.mapByMap} now={matchWords(order, [])}>
        <ol class={css["morph3-order"]}>
          {order.map((to, i) => (
            // Maps have no name but their number.
            <li key={i}>
              <label>
                <span>{messages.mapBecomes(i + 1)}</span>
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
        <p class="hint">{messages.ifTwoMapsChange}</p>
      </Fold>
    </section>
  );
}

/** How many objects do not take part. */
export function othersWords(): string {
  const count = (space.value?.objects.length ?? 1) - 1;
  if (count < 1) return "";
  return count === 1 ? messages.otherObjectStaysAs : messages.othersStay(count);
}

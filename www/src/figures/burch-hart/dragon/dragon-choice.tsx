import { useContext, useLayoutEffect } from "preact/hooks";
import { halfTurnWay } from "#format/path-words";
import { Segmented } from "#ui/controls/Segmented";
import { frond } from "#wasm/core";
import type { Parameter } from "../../kit/frame/frame";
import { oneOf } from "../../kit/state/fields";
import { Page, useNoted } from "../../kit/state/kept";
import { aboutDragon, DRAGONS, dragon, ends } from "./dragon";
import css from "./dragon-choice.module.css";

/** As it stands in the address of each figure. */
export const DRAGON = oneOf(DRAGONS.map(({ value }) => value));

/** Which dragon stands for the paper's: the same in all of its figures, so that each of their links says so. */
export function DragonChoice() {
  const page = useContext(Page);
  useLayoutEffect(() => {
    const opened = page.opened("dragon", DRAGON);
    if (opened) dragon.value = opened;
  }, [page]);
  useNoted("dragon", dragon.value);
  return (
    <div class={css["dragon-choice"]}>
      <Segmented
        label="Dragon"
        options={DRAGONS.map(({ value, label, about }) => ({ value, label, description: about }))}
        value={dragon.value}
        onChange={(next) => {
          dragon.value = next;
        }}
      />
      <p class={css["choice-about"]}>{aboutDragon(dragon.value)}.</p>
    </div>
  );
}

export const WHY_DRAGON =
  "The paper calls the first shape a dragon of three maps and prints no matrices. Two dragons of three maps stand for it here, one of them also mirrored.";

export function dragonParameters(): Parameter[] {
  return [
    { name: "First shape", value: aboutDragon(dragon.value) },
    { name: "Last shape", value: "gasket, three maps of scale ½" },
    { name: "Which map becomes which", value: "1 to 1, 2 to 2, 3 to 3" },
    { name: "How maps turn", value: turnWords() },
  ];
}

/** The default of a morph. Where a half turn is as short either way, eq 6 decides by the signs of its angles. */
function turnWords(): string {
  const { from, to } = ends.value;
  const halves = frond.halfTurns({ maps: from }, { maps: to }, {});
  const map = halves.findIndex((turn) => turn !== 0);
  if (map < 0) return "by the shortest turns";
  const way = halfTurnWay(halves[map] ?? 0);
  return `by the shortest turns; map ${map + 1} by half a turn, ${way} as the signs of eq. 6 have it`;
}

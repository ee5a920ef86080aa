import { useContext, useLayoutEffect } from "preact/hooks";
import { Segmented } from "#ui/controls/Segmented";
import type { Parameter } from "../../kit/frame/frame";
import { oneOf } from "../../kit/state/fields";
import { Page, useNoted } from "../../kit/state/kept";
import { aboutDragon, DRAGONS, dragon } from "./dragon";
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
    { name: "Which map becomes which", value: "1 to 1, 2 to 2, 3 to 3, by the shortest turns" },
  ];
}

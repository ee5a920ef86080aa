import { computed, signal } from "@preact/signals";
import { apartBy, apartWords } from "#geometry/maps/apart";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { MapBlocks } from "#ui/shapes/MapBlocks";
import { made, moved, parameters } from "../now";

/** So many maps are shown at first. */
const MAPS_AT_FIRST = 6;
/** What is printed the same is the same here. */
const SEEN = 0.5e-4;

const side = signal<"now" | "made">("now");
const all = signal(false);

const changed = (map: number, place: number) =>
  Math.abs((parameters.value[map]?.[place] ?? 0) - (made.value[map]?.[place] ?? 0)) > SEEN;

const count = computed(() => {
  let count = 0;
  parameters.value.forEach((map, i) => {
    for (let place = 0; place < map.length; place++) if (changed(i, place)) count++;
  });
  return count;
});

const apart = computed(() => apartBy(made.value, parameters.value, moved.value));

/** The parameters of the object now, and what in them is not as it was made. */
export function ParameterTable() {
  const now = side.value === "now";
  const maps = now ? parameters.value : made.value;
  const shown = all.value ? maps : maps.slice(0, MAPS_AT_FIRST);
  const numbers = 12 * maps.length;
  return (
    <section class="stack" aria-label="Its parameters">
      <div class="section-head">
        <h2>Its parameters</h2>
        <Segmented
          label="Which parameters"
          value={side.value}
          options={[
            { value: "now", label: "Now" },
            { value: "made", label: "As made" },
          ]}
          onChange={(next) => {
            side.value = next;
          }}
        />
      </div>
      <p class="hint">
        {count.value === 0
          ? "All as made: nothing was done to it."
          : `${count.value} of ${numbers} numbers are not as made${now ? " (underlined)" : ""}.`}
      </p>
      <MapBlocks
        label={now ? "Parameters now" : "Parameters as made"}
        maps={shown}
        mark="not as made"
        marked={now ? changed : () => false}
      />
      {maps.length > MAPS_AT_FIRST && (
        <Button
          kind="quiet"
          onClick={() => {
            all.value = !all.value;
          }}
        >
          {all.value ? `Show ${MAPS_AT_FIRST} only` : `Show all ${maps.length}`}
        </Button>
      )}
      {count.value > 0 && (
        <p class="notes">
          <span>
            Drawing with these numbers, or drawing as made and moving every point, is the same picture.
          </span>
          <span class="number">{apartWords(apart.value)}</span>
        </p>
      )}
    </section>
  );
}

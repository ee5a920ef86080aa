import { useMemo, useState } from "preact/hooks";
import { apartBy, apartWords } from "#geometry/maps/apart";
import { axesOf, type Row } from "#geometry/maps/row";
import { Button } from "../controls/Button";
import { Segmented } from "../controls/Segmented";
import { MapBlocks } from "../shapes/MapBlocks";

/** So many maps are shown at first. */
const MAPS_AT_FIRST = 6;
/** What is printed the same is the same here. */
const SEEN = 0.5e-4;

interface ParameterTableProps<Map extends Row> {
  /** Its maps before anything was done to it, and now. */
  made: readonly Map[];
  now: readonly Map[];
  /** All that was done to it. */
  moved: Map;
  as: "made" | "taken";
}

/** The parameters of a shape now, and what in them is not as it was. */
export function ParameterTable<Map extends Row>({ made, now: present, moved, as }: ParameterTableProps<Map>) {
  const [side, setSide] = useState<"now" | "before">("now");
  const [all, setAll] = useState(false);
  const changed = (map: number, place: number) =>
    Math.abs((present[map]?.[place] ?? 0) - (made[map]?.[place] ?? 0)) > SEEN;
  const count = present.reduce(
    (sum, map, i) => sum + [...map].filter((_, place) => changed(i, place)).length,
    0,
  );
  const apart = useMemo(() => apartBy(made, present, moved), [made, present, moved]);
  const now = side === "now";
  const maps = now ? present : made;
  const axes = axesOf(moved);
  return (
    <section class="stack" aria-label="Its parameters">
      <div class="section-head">
        <h2>Its parameters</h2>
        <Segmented
          label="Which parameters"
          value={side}
          options={[
            { value: "now", label: "Now" },
            { value: "before", label: `As ${as}` },
          ]}
          onChange={setSide}
        />
      </div>
      <p class="hint">
        {count === 0
          ? `All as ${as}: nothing was done to it.`
          : `${count} of ${axes * (axes + 1) * maps.length} numbers are not as ${as}${now ? " (underlined)" : ""}.`}
      </p>
      <MapBlocks
        label={now ? "Parameters now" : `Parameters as ${as}`}
        maps={all ? maps : maps.slice(0, MAPS_AT_FIRST)}
        mark={`not as ${as}`}
        marked={now ? changed : () => false}
      />
      {maps.length > MAPS_AT_FIRST && (
        <Button kind="quiet" onClick={() => setAll(!all)}>
          {all ? `Show ${MAPS_AT_FIRST} only` : `Show all ${maps.length}`}
        </Button>
      )}
      {count > 0 && (
        <p class="notes">
          <span>
            Drawing with these numbers, or drawing as {as} and moving every point, is the same picture.
          </span>
          <span class="number">{apartWords(apart)}</span>
        </p>
      )}
    </section>
  );
}

import { useMemo, useState } from "preact/hooks";
import { apartBy, apartWords } from "#geometry/maps/apart";
import { axesOf, type Row } from "#geometry/maps/row";
import { Button } from "../controls/Button";
import { Segmented } from "../controls/Segmented";
import * as messages from "../messages";
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
  const was = as === "made" ? messages.asMade : messages.asBefore;
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
    <section class="stack" aria-label={messages.parameters}>
      <div class="section-head">
        <h2>{messages.parameters}</h2>
        <Segmented
          label={messages.showParameters}
          value={side}
          options={[
            { value: "now", label: messages.now },
            { value: "before", label: as === "made" ? messages.asMadeLabel : messages.asBeforeLabel },
          ]}
          onChange={setSide}
        />
      </div>
      <p class="hint">
        {count === 0
          ? messages.allAs(was)
          : (now ? messages.numbersUnderlined : messages.numbersChanged)(
              count,
              axes * (axes + 1) * maps.length,
              was,
            )}
      </p>
      <MapBlocks
        label={now ? messages.parametersNow : messages.parametersAs(was)}
        maps={all ? maps : maps.slice(0, MAPS_AT_FIRST)}
        mark={messages.notAs(was)}
        marked={now ? changed : () => false}
      />
      {maps.length > MAPS_AT_FIRST && (
        <Button kind="quiet" onClick={() => setAll(!all)}>
          {all ? messages.showOnly(MAPS_AT_FIRST) : messages.showAll(maps.length)}
        </Button>
      )}
      {count > 0 && (
        <p class="notes">
          <span>{messages.samePicture(was)}</span>
          <span class="number">{apartWords(apart)}</span>
        </p>
      )}
    </section>
  );
}

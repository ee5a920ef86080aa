import { useMemo } from "preact/hooks";
import { type Apart, apartBy, apartWords } from "#geometry/maps/apart";
import { Button } from "#ui/controls/Button";
import { MapBlocks } from "#ui/shapes/MapBlocks";
import type { MapRow3, SpaceObject, SpaceView } from "#wasm/api";
import { solid } from "#wasm/space";
import layout from "../../kit/frame/layout.module.css";
import { whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import spaceCss from "./space.module.css";
import { SpacePicture } from "./space-picture";

/** The middle of the natural scene: it lies along x before the eye. */
export const MIDDLE = [14, 0, -1] as const;

/** The natural scene, how many maps it has, and where the eye of the paper is. */
export function useScene() {
  return useMemo(() => {
    const made = solid.naturalScene();
    const count = made.reduce((sum, object) => sum + object.maps.length, 0);
    return { made, count, home: solid.defaultView({ objects: made, light: solid.defaultSpace().light }) };
  }, []);
}

/** Whose parameters are shown. */
const OF = kept(0, whole(0, 30));

interface SceneryProps {
  made: readonly SpaceObject[];
  /** What is done to each of them. */
  by: MapRow3;
  view: SpaceView;
  onView: (view: SpaceView) => void;
  label: string;
}

/** Several objects, each with parameters of its own: all are moved by moving these. */
export function Scenery({ made, by, view, onView, label }: SceneryProps) {
  const [chosen, setChosen] = useKept("of", ...OF);
  const objects = useMemo(
    () =>
      made.map(({ maps, tint }) => ({
        maps: solid.conjugate3(maps, by),
        ...(tint === undefined ? {} : { tint }),
      })),
    [made, by],
  );
  const apart = useMemo(
    () => worst(made.map(({ maps }, i) => apartBy(maps, objects[i]?.maps ?? [], by, 500))),
    [made, objects, by],
  );
  const object = made[chosen];
  const now = objects[chosen]?.maps ?? [];
  const changed = (map: number, place: number) =>
    Math.abs((now[map]?.[place] ?? 0) - (object?.maps[map]?.[place] ?? 0)) > 0.005;
  return (
    <div class={`${spaceCss["space-figure"]} ${spaceCss["wide"]}`}>
      <SpacePicture objects={objects} view={view} onView={onView} label={label} />
      <div class={spaceCss["space-table"]}>
        <h2>Transform parameters of the {object?.name.toLowerCase()}</h2>
        {/* biome-ignore lint/a11y/useSemanticElements: a fieldset is for forms */}
        <div class={layout["buttons"]} role="group" aria-label="Whose parameters">
          {made.map(({ name }, i) => (
            <Button key={name} pressed={i === chosen} onClick={() => setChosen(i)}>
              {name}
            </Button>
          ))}
        </div>
        <MapBlocks
          label={`Transform parameters of the ${object?.name.toLowerCase()}`}
          maps={now}
          digits={2}
          marked={changed}
          mark="not as made"
        />
        <p class={spaceCss["space-note"]} role="status">
          <strong>Conjugated parameters, or moved points?</strong> Of {made.length} objects the worst.{" "}
          {apartWords(apart)}
        </p>
      </div>
    </div>
  );
}

/** Of several the one that is farthest apart for its size. */
function worst(all: readonly Apart[]): Apart {
  return all.reduce((a, b) => (b.most / b.size > a.most / a.size ? b : a));
}

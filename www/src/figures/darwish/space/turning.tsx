import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { apartBy, apartWords } from "#geometry/maps/apart";
import { MapBlocks } from "#ui/shapes/MapBlocks";
import type { MapRow3, Point3, SpaceView } from "#wasm/api";
import { solid } from "#wasm/space";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { type Field, list, whole } from "../../kit/state/fields";
import spaceCss from "./space.module.css";
import { SpacePicture } from "./space-picture";

/** Degrees about x, then y, then z. */
export type Angles = Point3;

/** As they stand in an address. */
export const ANGLES = list(whole(-180, 180), 3, 3) as Field<Angles>;

const AXES = ["x", "y", "z"] as const;

export const inRadians = (angles: Angles) => angles.map((x) => (x * Math.PI) / 180) as Point3;

/** The three turns of the paper, by sliders. */
export function AngleSliders({ angles, onChange }: { angles: Angles; onChange: (angles: Angles) => void }) {
  return (
    <div class={layout["controls"]}>
      {AXES.map((axis, k) => (
        <SliderControl
          key={axis}
          label={`turned about ${axis}`}
          range={[-180, 180]}
          whole
          value={angles[k] ?? 0}
          text={`${fixed(angles[k] ?? 0, 0)}°`}
          valueText={`${fixed(angles[k] ?? 0, 0)} degrees`}
          onChange={(next) => onChange(angles.with(k, next) as Angles)}
        />
      ))}
    </div>
  );
}

interface ConjugatedProps {
  made: readonly MapRow3[];
  by: MapRow3;
  /** The parameters now, where they come of more than one step. */
  now?: readonly MapRow3[];
  view: SpaceView;
  onView: (view: SpaceView) => void;
  label: string;
  digits?: number;
  wide?: boolean;
  /** What moves it: close to the picture. */
  children: ComponentChildren;
}

/** The picture drawn from the conjugated parameters, these parameters, and how far that is from moving the points. */
export function Conjugated(props: ConjugatedProps) {
  const { made, by, view, onView, label, digits = 2, wide = false } = props;
  const now = useMemo(() => props.now ?? solid.conjugate3([...made], by), [props.now, made, by]);
  const objects = useMemo(() => [{ maps: [...now] }], [now]);
  const apart = useMemo(() => apartBy(made, now, by), [made, now, by]);
  const seen = 0.5 * 10 ** -digits;
  const changed = (map: number, place: number) =>
    Math.abs((now[map]?.[place] ?? 0) - (made[map]?.[place] ?? 0)) > seen;
  return (
    <div class={`${spaceCss["space-figure"]} ${wide ? spaceCss["wide"] : ""}`}>
      <div class={spaceCss["space-hand"]}>
        <SpacePicture objects={objects} view={view} onView={onView} label={label} />
        {props.children}
      </div>
      <div class={spaceCss["space-table"]}>
        <h2>Transform parameters</h2>
        <MapBlocks
          label="Transform parameters now"
          maps={now}
          digits={digits}
          marked={changed}
          mark="not as made"
        />
        <p class={spaceCss["space-note"]} role="status">
          <strong>Conjugated parameters, or moved points?</strong> {apartWords(apart)}
        </p>
      </div>
    </div>
  );
}

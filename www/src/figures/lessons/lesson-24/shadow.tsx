import type { ComponentChildren } from "preact";
import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import type { MapRow3 } from "#wasm/api";
import { SpacePicture } from "../../darwish/space/space-picture";
import { SliderControl } from "../../kit/frame/control";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { Picture } from "../../kit/picture/picture";
import css from "./shadow.module.css";
import { type Eye, eyeOf, SHADOW_BOX, shadowMaps, viewOf } from "./shapes";

interface ShadowProps {
  maps: MapRow3[];
  /** What it is, in words. */
  name: string;
  eye: Eye;
  onEye: (eye: Eye) => void;
}

/** A shape of space seen from the lamp, its shadow beside it, and sliders that turn both. */
export function Shadow({ maps, name, eye, onEye }: ShadowProps) {
  const objects = useMemo(() => [{ maps }], [maps]);
  const view = useMemo(() => viewOf(eye), [eye]);
  const where = `${fixed(eye.turn, 0)} degrees round and ${fixed(eye.tilt, 0)} degrees up`;
  return (
    <>
      <div class={`${layout["two-columns"]} ${layout["even"]} ${css["square"]}`}>
        <Panel caption="From the lamp. Drag it.">
          <SpacePicture
            objects={objects}
            view={view}
            onView={(next) => onEye(eyeOf(next))}
            label={`${name}, seen from ${where}`}
          />
        </Panel>
        <ShadowPanel maps={maps} eye={eye} label={`The shadow of ${name}, lit from ${where}`} />
      </div>
      <div class={layout["controls"]}>
        <SliderControl
          label="lamp, round"
          range={[-180, 180]}
          whole
          value={eye.turn}
          text={`${fixed(eye.turn, 0)}°`}
          valueText={`${fixed(eye.turn, 0)} degrees`}
          onChange={(turn) => onEye({ ...eye, turn })}
        />
        <SliderControl
          label="lamp, up"
          range={[-90, 90]}
          whole
          value={eye.tilt}
          text={`${fixed(eye.tilt, 0)}°`}
          valueText={`${fixed(eye.tilt, 0)} degrees`}
          onChange={(tilt) => onEye({ ...eye, tilt })}
        />
      </div>
    </>
  );
}

interface ShadowPanelProps {
  maps: MapRow3[];
  eye: Eye;
  label: string;
  caption?: ComponentChildren;
}

/** The shadow alone. */
export function ShadowPanel({ maps, eye, label, caption = "Its shadow." }: ShadowPanelProps) {
  const flat = useMemo(() => shadowMaps(maps, eye), [maps, eye]);
  return (
    <Panel caption={caption}>
      <Picture maps={flat} box={SHADOW_BOX} label={label} />
    </Panel>
  );
}

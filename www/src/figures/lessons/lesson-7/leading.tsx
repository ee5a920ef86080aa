/** The morph of this lesson, and ways over one waypoint. */
import type { Uv } from "#geometry/path";
import type { PathCheck } from "#wasm/api";
import { prover } from "#wasm/proof";
import { SliderControl } from "../../kit/frame/control";
import { preset } from "../../kit/frame/studio-link";
import type { Ends } from "../../kit/maps/morphs";

export const FROM = "dragon-3";
export const TO = "terdragon";
export const EPSILON = 1 / 600;
export const SAMPLES = 301;
/** Samples of the map of shapes along each side. */
export const SIZE = 121;

let kept: Ends | null = null;

/** Both shapes, read from the gallery once. */
export function ends(): Ends {
  kept ??= { from: preset(FROM).maps, to: preset(TO).maps };
  return kept;
}

/** Whether the morph holds together on a way, moment by moment. */
export function judge(points: Uv[]): PathCheck {
  const { from, to } = ends();
  return prover().checkPath({ maps: from }, { maps: to }, points, { epsilon: EPSILON, samples: SAMPLES });
}

interface CoordinateProps {
  name: "u" | "v";
  about: string;
  value: number;
  onChange: (value: number) => void;
}

/** One number of a waypoint. */
export function Coordinate({ name, about, value, onChange }: CoordinateProps) {
  return (
    <SliderControl
      label={`waypoint, ${about}`}
      name={`Waypoint ${name}, ${about}`}
      symbol={name}
      range={[-1, 2]}
      step={0.05}
      value={value}
      onChange={onChange}
    />
  );
}

import { useMemo } from "preact/hooks";
import { directed, loadDirected } from "#wasm/directed";
import { look } from "../../kit/directed/look";
import { StatePicture } from "../../kit/directed/state-picture";

export const needs = [loadDirected];

export function Thumb() {
  const system = useMemo(() => directed.directedPresets().find(({ id }) => id === "rauzy")?.system, []);
  const seen = useMemo(() => (system ? look(system) : null), [system]);
  if (!system || seen === null || typeof seen === "string") return null;
  const [box] = seen.boxes;
  return box ? <StatePicture system={system} state={0} box={box} level={0} label={null} /> : null;
}

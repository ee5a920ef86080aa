import type { EpsilonProjection } from "#wasm/api";
import { MapBlocks } from "./MapBlocks";

interface FlattenedMapsProps {
  of: EpsilonProjection;
  /** How many maps are shown. */
  most: number;
}

/** Parameters of a flattened shape: those that grow without bound the thinner it becomes are marked. */
export function FlattenedMaps({ of: { maps, diverging }, most }: FlattenedMapsProps) {
  return (
    <MapBlocks
      label="Parameters of the flattened shape"
      maps={maps.slice(0, most)}
      digits={3}
      mark="grows"
      marked={(map, place) =>
        diverging.some(([other, row, column = 2]) => other === map && place === 3 * row + column)
      }
    />
  );
}

import type { EpsilonProjection } from "#wasm/api";
import * as messages from "../messages";
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
      label={messages.parametersFlattenedShape}
      maps={maps.slice(0, most)}
      digits={3}
      mark={messages.grows}
      marked={(map, place) =>
        diverging.some(([other, row, column = 2]) => other === map && place === 3 * row + column)
      }
    />
  );
}

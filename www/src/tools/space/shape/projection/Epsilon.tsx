import { useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { divergingWords } from "#format/placement";
import { SliderField } from "#ui/controls/SliderField";
import { Problem } from "#ui/panel/Problem";
import { FlattenedMaps } from "#ui/shapes/FlattenedMaps";
import type { EpsilonProjection, MapRow3, Point3 } from "#wasm/api";
import { solid } from "#wasm/space";
import * as messages from "../messages";

const MAPS_SHOWN = 3;

interface EpsilonProps {
  maps: MapRow3[];
  direction: Point3;
  format: (value: number) => string;
}

const POWERS = {
  to: (value: number) => Math.log10(value),
  from: (at: number) => Number((10 ** at).toPrecision(2)),
};

/** The way of the paper: flattened by epsilon, what becomes of the parameters? */
export function Epsilon({ maps, direction, format }: EpsilonProps) {
  const [epsilon, setEpsilon] = useState(0.1);
  const found = flattened(maps, direction, epsilon);
  return (
    <>
      <SliderField
        field={{ step: 0.01 }}
        label={messages.remainingThickness}
        symbol="ε"
        value={epsilon}
        min={-6}
        max={0}
        step={0.1}
        digits={6}
        scale={POWERS}
        onChange={(next) => {
          if (!(next > 0 && next <= 1)) return messages.enterNumberAbove0;
          setEpsilon(next);
          return undefined;
        }}
      />
      {"why" in found ? (
        <Problem words={found.why} />
      ) : (
        <>
          <p class="hint" role="status">
            {messages.largestNumber(format(found.largest), divergingWords(found.diverging))}
          </p>
          <FlattenedMaps of={found} most={MAPS_SHOWN} />
          <p class="hint">
            {found.maps.length > MAPS_SHOWN && `${messages.firstOfMaps(MAPS_SHOWN, found.maps.length)} `}
            {messages.shadowAxes}
          </p>
        </>
      )}
    </>
  );
}

function flattened(maps: MapRow3[], direction: Point3, epsilon: number): EpsilonProjection | { why: string } {
  try {
    return solid.epsilonProjection(maps, direction, epsilon);
  } catch (problem) {
    return { why: wordsOf(problem) };
  }
}

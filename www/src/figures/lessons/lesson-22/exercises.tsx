import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import layout from "../../kit/frame/layout.module.css";
import { number } from "../../kit/state/fields";
import { useKept } from "../../kit/state/kept";
import { Exercise } from "../frame/exercise";
import {
  apartFromPlain,
  DELTA,
  FAR,
  isQuietAndLively,
  LIVELY,
  NEAR,
  NEARLY_PLAIN,
  QUIET,
  WHOLE,
} from "./answer";
import { Both, Locality, Roughness } from "./bent";

export function Exercises() {
  return (
    <>
      <Nearly />
      <Between />
    </>
  );
}

const percent = (part: number) => `${fixed(100 * part, 1)}%`;

function Nearly() {
  const [delta, setDelta] = useKept("x1.roughness", DELTA, number(0, 2, 2));
  const apart = useMemo(() => apartFromPlain(WHOLE, 0, delta), [delta]);
  return (
    <Exercise
      number={1}
      ask={`The locality stays at 0, so that all levels take part. Choose the roughness so that no point is farther from where the plain bend puts it than ${percent(NEARLY_PLAIN)} of the size; but do not turn it off: 0.1 at least.`}
      hints={[
        "The less the roughness, the smaller the shares of all levels but the first.",
        "A roughness of 0.25 leaves three quarters of the lift to the first level.",
      ]}
      solved={apart <= NEARLY_PLAIN && delta >= 0.1}
      status={`At most ${percent(apart)} from the plain bend.`}
    >
      <Both kb={0} delta={delta} />
      <div class={layout["controls"]}>
        <Roughness value={delta} onChange={setDelta} />
      </div>
    </Exercise>
  );
}

function Between() {
  const [kb, setKb] = useKept("x2.locality", 0, number(0, 12, 1));
  const [far, near] = useMemo(() => [apartFromPlain(FAR, kb, DELTA), apartFromPlain(NEAR, kb, DELTA)], [kb]);
  return (
    <Exercise
      number={2}
      ask={`The roughness stays at ${DELTA}. Choose the locality so that the far corner, piece 1111, is quiet: within ${percent(QUIET)} of its size of the plain bend. Piece 2333, next to the pull, is to be lively: ${percent(LIVELY)} of its size from the plain bend, or more.`}
      hints={[
        "With more locality a point takes the pull of places that are nearer to it. Those of the far corner know little of the pull.",
        "At 2 the far corner is not quiet yet, and at 4 piece 2333 is no longer lively.",
      ]}
      solved={isQuietAndLively(far, near)}
      status={`Piece 1111: ${percent(far)} of its size. Piece 2333: ${percent(near)} of its size.`}
    >
      <Both kb={kb} delta={DELTA} />
      <div class={layout["controls"]}>
        <Locality value={kb} onChange={setKb} />
      </div>
    </Exercise>
  );
}

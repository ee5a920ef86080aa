import { useMemo } from "preact/hooks";
import { frond } from "#wasm/core";
import { Collisions, groups, windowOf } from "../../kit/connectedness/collisions";
import { Buffer } from "../../kit/connectedness/index-buffer";
import { Panel } from "../../kit/frame/panel";
import { Chip } from "../../kit/frame/verdict";
import { gasket } from "../../kit/maps/families";

const DRAWN = 40_000;
const SEED = 1;

/** A buffer of so many pixels a side with the marks of a triangle of scale `r`: the same at every try. */
export function bufferOf(r: number, size: number): Collisions {
  const maps = gasket(r);
  const { min, max } = frond.bounds({ maps });
  const points = frond.attractor({ maps, probabilities: [1, 1, 1] }, { points: DRAWN, seed: SEED });
  const run = new Collisions(size, windowOf(min, max), points);
  run.plotTo(DRAWN);
  return run;
}

/** In how many pieces a buffer seems to be. */
export function seemsIn(run: Collisions): number {
  return groups(
    3,
    run.edges.map((edge) => edge.between),
  ).count;
}

/** A buffer, and what it seems to say. */
export function Pixels({ r, size }: { r: number; size: number }) {
  const run = useMemo(() => bufferOf(r, size), [r, size]);
  const count = seemsIn(run);
  return (
    <Panel
      caption={
        <>
          <span class="number">
            {size} × {size} pixels
          </span>
          <Chip
            tone={count === 1 ? "close" : "broken"}
            text={count === 1 ? "Connected" : "In pieces"}
            aside={count === 1 ? "it seems" : "seen apart"}
          />
        </>
      }
    >
      <Buffer
        run={run}
        count={run.count}
        label={`The shape in ${size} by ${size} pixels: ${count === 1 ? "pieces share pixels" : "no pixel is shared"}.`}
      />
    </Panel>
  );
}

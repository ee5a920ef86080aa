import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { verdictPhrase } from "#format/verdict";
import type { Uv } from "#geometry/path";
import { EXACT, VerdictChip } from "../../kit/frame/verdict";
import { boxAround, mapsAt } from "../../kit/maps/morphs";
import { Picture } from "../../kit/picture/picture";
import { type Judged, useVerdict } from "../../kit/workers";
import { ends } from "./map";

/** The shape of a place and what is known of it, as far as it is known now. */
export function usePlace([u, v]: Uv) {
  const maps = useMemo(() => mapsAt(ends(), [u, v]), [u, v]);
  const judged: Judged | null = useVerdict(maps, EXACT);
  const answer = judged?.maps === maps ? judged.answer : null;
  return { maps, judged, answer };
}

interface HereProps {
  at: Uv;
  of: ReturnType<typeof usePlace>;
}

/** The shape of a place, as large as it fits, with its verdict. */
export function Here({ at: [u, v], of: { maps, judged, answer } }: HereProps) {
  const box = useMemo(() => boxAround([maps]), [maps]);
  return (
    <>
      <Picture
        maps={maps}
        box={box}
        label={`The shape of u = ${fixed(u, 3)}, v = ${fixed(v, 3)}: ${verdictPhrase(answer, EXACT)}`}
      />
      <VerdictChip epsilon={EXACT} answer={judged?.answer ?? null} stale={answer === null} />
    </>
  );
}

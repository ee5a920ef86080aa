/** The paper's fits of the leaf: all of each, and where its copies should meet. */
import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import type { Box } from "#geometry/boxes";
import type { Collage } from "#workers/fit/curve";
import { numbersPerMap } from "#workers/fit/map-numbers";
import { SliderControl } from "../../kit/frame/control";
import { Panel } from "../../kit/frame/panel";
import { whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { type OutlineLine, OutlineView } from "./outline-view";

/** The leaf, thin. */
export const OUTLINE = { colour: "quiet", width: 1, closed: true } as const;

export interface PanelProps {
  leaf: Float64Array | null;
  box: Box;
}

interface CollagePanelProps extends PanelProps {
  maps: number;
  collage: Collage | null;
  tied: boolean;
  separable: boolean;
}

/** The paper's fit: the leaf thin behind it, its gaps marked. */
export function CollagePanel({ maps, collage, leaf, box, tied, separable }: CollagePanelProps) {
  const lines = useMemo((): OutlineLine[] => {
    if (!leaf) return [];
    if (!collage) return [{ points: leaf, ...OUTLINE }];
    const pieces = piecesOf(collage).map((points): OutlineLine => ({ points, colour: 1, width: 1.5 }));
    const gaps: OutlineLine[] = [];
    for (let i = 0; i + 3 < collage.gaps.length; i += 4) {
      gaps.push({ points: collage.gaps.slice(i, i + 4), colour: "bad", width: 2.5 });
    }
    return [{ points: leaf, ...OUTLINE }, ...pieces, ...(collage.widest > 1e-6 ? gaps : [])];
  }, [leaf, collage]);
  const gapWords = collage
    ? collage.widest > 1e-6
      ? `gaps up to ${fixed(collage.widest)}% of the diagonal, ${fixed(collage.mean)}% on average`
      : "no gaps"
    : "fitting …";
  return (
    <Panel
      name={`${maps} maps`}
      words={`${numbersPerMap(separable) * maps} numbers`}
      caption={<span class="number">{gapWords}</span>}
    >
      <OutlineView
        box={box}
        lines={lines}
        label={`The paper’s fit with ${maps} maps${tied ? ", ends tied" : ""}: ${gapWords}`}
      />
    </Panel>
  );
}

/** Half the side of the magnified part, in parts of the leaf's width. */
const MAGNIFIED_HALF = 0.035;
/** Which of the gaps is shown. */
const GAP = kept(0, whole(0, 99));

interface CloserProps extends PanelProps {
  maps: number;
  collage: Collage | null;
}

/** Where two copies of the paper's fit should meet: the places in the order of their gaps. */
export function Closer({ maps, collage, leaf, box }: CloserProps) {
  const [rank, setRank] = useKept("gap", ...GAP);
  const joints = useMemo(() => (collage ? jointsOf(collage) : []), [collage]);
  const joint = joints[Math.min(rank, joints.length - 1)];
  const near = MAGNIFIED_HALF * (box.x1 - box.x0);
  const [x, y] = joint?.at ?? [0, 0];
  const part = useMemo(() => ({ x0: x - near, y0: y - near, x1: x + near, y1: y + near }), [x, y, near]);
  const lines = useMemo((): OutlineLine[] => {
    if (!leaf || !collage || !joint) return [];
    return [
      { points: leaf, ...OUTLINE, width: 1.5 },
      ...piecesOf(collage).map((points, i): OutlineLine => ({ points, colour: i % 2, width: 2.25 })),
      { points: joint.ends, colour: "bad", width: 3 },
      { points: joint.ends, colour: "bad", dots: 8 },
    ];
  }, [leaf, collage, joint]);
  const diagonal = Math.hypot(box.x1 - box.x0, box.y1 - box.y0);
  const wide = joint ? (100 * joint.wide) / diagonal : 0;
  const words = wide > 1e-6 ? `a gap of ${fixed(wide)}% of the diagonal` : "no gap";
  return (
    <Panel
      caption={
        <SliderControl
          label="where copies should meet"
          name="Gap"
          range={[1, Math.max(2, joints.length)]}
          whole
          value={Math.min(rank, Math.max(0, joints.length - 1)) + 1}
          text={joint ? words.replace(" of the diagonal", "") : "…"}
          valueText={`gap ${rank + 1} of ${joints.length}, the widest first: ${words}`}
          onChange={(next) => setRank(next - 1)}
        />
      }
    >
      <OutlineView
        box={part}
        lines={lines}
        label={`Where two of ${maps} copies should meet, magnified: ${words}`}
      />
    </Panel>
  );
}

/** The steps from piece to piece, the widest first. */
function jointsOf({ gaps }: Collage) {
  const joints = [];
  for (let i = 0; i + 3 < gaps.length; i += 4) {
    const ends = gaps.slice(i, i + 4);
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = ends;
    const at = [(x0 + x1) / 2, (y0 + y1) / 2] as const;
    joints.push({ ends, at, wide: Math.hypot(x1 - x0, y1 - y0) });
  }
  return joints.sort((p, q) => q.wide - p.wide);
}

/** A polyline for each piece. */
function piecesOf({ points, starts }: Collage): Float64Array[] {
  return [...starts].map((start, i) => points.subarray(2 * start, 2 * (starts[i + 1] ?? points.length / 2)));
}

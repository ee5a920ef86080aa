/** Curves of the plane to begin with. */

import * as messages from "../../messages";
import { alongSide, type Factor, type Place, type PlaneCurve } from "./curve";

export interface Example {
  id: string;
  name: string;
  about: string;
  make: () => PlaneCurve;
}

const HIGH = Math.sqrt(3) / 2;

/** Every piece a similar copy of the whole; `mirrored` says which ones are mirrored, `back` which run backwards. */
function similar(
  places: readonly Place[],
  mirrored: readonly boolean[],
  back: readonly boolean[] = [],
): PlaneCurve {
  const last = places.length - 1;
  const curve: PlaneCurve = {
    points: places.map(([x, y], i) => [i / last, x, y]),
    pieces: places.slice(1).map((_, i) => ({ factor: [0, 0, 0, 0], span: back[i] ? [last, 0] : [0, last] })),
  };
  const pieces = curve.pieces.map((piece, i) => {
    const factor: Factor = alongSide(curve, i, mirrored[i] ?? false) ?? piece.factor;
    return { ...piece, factor };
  });
  return { ...curve, pieces };
}

export const EXAMPLES: readonly Example[] = [
  {
    id: "koch",
    name: messages.kochsCurve,
    about: messages.fourCopiesEachThird,
    make: () =>
      similar(
        [
          [0, 0],
          [1 / 3, 0],
          [1 / 2, HIGH / 3],
          [2 / 3, 0],
          [1, 0],
        ],
        [],
      ),
  },
  {
    id: "arrowhead",
    name: messages.arrowhead,
    about: messages.threeCopiesEachHalf,
    make: () =>
      similar(
        [
          [0, 0],
          [0.25, HIGH / 2],
          [0.75, HIGH / 2],
          [1, 0],
        ],
        [true, false, true],
      ),
  },
  {
    id: "dragon",
    name: messages.dragon,
    about: messages.twoCopiesEach1,
    make: () =>
      similar(
        [
          [0, 0],
          [0.5, 0.5],
          [1, 0],
        ],
        [],
        [false, true],
      ),
  },
  {
    id: "leaning",
    name: messages.togetherSection24,
    about: messages.copiesLeanXDepends,
    make: () => ({
      points: [
        [0, 0, 0],
        [0.5, 0.5, 0.45],
        [1, 1, 0],
      ],
      pieces: [
        { factor: [0.55, 0.35, 0.1, -0.5], span: [0, 2] },
        { factor: [0.5, -0.3, 0.2, 0.45], span: [0, 2] },
      ],
    }),
  },
  {
    id: "apart",
    name: messages.apartEq8,
    about: messages.xAndYTwo,
    make: () => ({
      points: [
        [0, 0, 0],
        [0.25, 0.7, 0.4],
        [0.5, 0.3, 0.8],
        [0.75, 1, 0.6],
        [1, 0.8, -0.1],
      ],
      pieces: [
        { factor: [0.4, 0, 0, -0.5], span: [0, 4] },
        { factor: [-0.35, 0, 0, 0.45], span: [0, 4] },
        { factor: [0.45, 0, 0, 0.4], span: [4, 0] },
        { factor: [0.3, 0, 0, -0.45], span: [0, 4] },
      ],
    }),
  },
];

/** Small pictures of the figures of Darwish, by the addresses of their pages. */

import { useMemo, useRef } from "preact/hooks";
import { about3, scale3, turns3 } from "#geometry/maps/affine3";
import type { Intersection3, SpaceView } from "#wasm/api";
import { frond } from "#wasm/core";
import { loadDirected } from "#wasm/directed";
import type { Thumbs } from "../figure";
import { preset } from "../kit/frame/studio-link";
import { boxAround } from "../kit/maps/morphs";
import { usePixels } from "../kit/picture/canvas";
import { Picture } from "../kit/picture/picture";
import { MeetGraph } from "./open-question/product-graph";
import { gridOf, shapeOf } from "./shared-grid/grids";
import { boxOf, useMeeting } from "./shared-grid/meeting";
import { Drawing } from "./shared-grid/overlay";
import overlayCss from "./shared-grid/overlay.module.css";
import type { Shift } from "./shared-grid/shift";
import {
  PRINTED_MIDDLE,
  PYRAMID_AWAY,
  printedTriangle,
  pyramid,
  pyramidMiddle,
  triangle,
} from "./space/shapes";
import { ALONG_X, FROM_FAR, FRONT, turnedHalves } from "./space/small";
import { TREE, TREE_VIEW } from "./space/small-tree";
import { SpaceDots } from "./space/space-dots";

const HALVES = triangle("halves");

const FigureI = () => <SpaceDots maps={HALVES} view={FRONT} />;

const TURNED = turnedHalves(triangle("halves"), turns3([-0.54, -0.61, -0.42]));

const FigureIi = () => <SpaceDots maps={TURNED} view={FRONT} />;

const TURNED_BY_THE_EYE = turnedHalves(triangle("halves"), turns3([-0.49, 0.37, 2.69]));

const FigureIii = () => <SpaceDots maps={TURNED_BY_THE_EYE} view={{ ...ALONG_X, target: [0, -0.22, 0] }} />;

const PRINTED = printedTriangle();

const FigureIv = () => <SpaceDots maps={PRINTED} view={{ ...ALONG_X, target: PRINTED_MIDDLE }} />;

const PYRAMID = pyramid(pyramidMiddle(PYRAMID_AWAY));

const FigureV = () => <SpaceDots maps={PYRAMID} view={FROM_FAR} />;

const MIDDLE = pyramidMiddle(PYRAMID_AWAY);
const TURNED_PYRAMID = turnedHalves(pyramid(MIDDLE), about3(turns3([0, -0.79, -0.35]), MIDDLE));

const FigureVi = () => <SpaceDots maps={TURNED_PYRAMID} view={FROM_FAR} />;

const FigureVii = () => <SpaceDots maps={TREE} view={TREE_VIEW} />;

/** From another side. */
const ASIDE = { ...TREE_VIEW, turn: 2.1, tilt: 0.35 };

const FigureViii = () => <SpaceDots maps={TREE} view={ASIDE} />;

function Section34() {
  const { maps, box } = useMemo(() => {
    const { maps } = frond.conjugate(preset("fern"), [0.75, 0.72, -0.4, 0.7, 0, 0]);
    return { maps, box: boxAround([maps]) };
  }, []);
  return <Picture maps={maps} box={box} label={null} />;
}

/** A tetrahedron, nearly flat. */
const FLAT_TETRAHEDRON = (
  [
    [1, 1, 0.03],
    [1, -1, -0.03],
    [-1, 1, -0.03],
    [-1, -1, 0.03],
  ] as const
).map((corner) => about3(scale3([0.5, 0.5, 0.5]), [...corner]));
const FLAT_VIEW: SpaceView = { target: [0, 0, 0], distance: 7, turn: 0.5, tilt: 0.4, angle: 0.42 };

const Section35 = () => <SpaceDots maps={FLAT_TETRAHEDRON} view={FLAT_VIEW} />;

/** Ways from a shift to another by these pairs of maps. */
const ways = (from: number, to: number, pairs: readonly (readonly [first: number, second: number])[]) =>
  pairs.map(([first, second]) => ({ from, first, second, to }));
const FOUR = [0, 1, 2, 3] as const;

/** The product of a bar and a dust on one line, as its page has it: nothing needs to be fetched for it. */
const PRODUCT: Pick<Intersection3, "shifts" | "arrows"> = {
  shifts: [
    [0, 0, 0],
    [0, -1, 0],
    [0, 1, 0],
    [1, -1, 0],
    [-1, -1, 0],
  ],
  arrows: [
    ...ways(0, 1, [[7, 7]]),
    ...ways(0, 2, [[8, 8]]),
    ...ways(
      1,
      1,
      [0, 1, 2, 3, 4].map((k) => [k, k]),
    ),
    ...ways(
      1,
      3,
      FOUR.map((k) => [k, k + 1]),
    ),
    ...ways(
      1,
      4,
      FOUR.map((k) => [k + 1, k]),
    ),
    ...ways(2, 2, [
      [5, 5],
      [6, 6],
    ]),
    ...ways(3, 3, [[4, 0]]),
    ...ways(4, 4, [[0, 4]]),
  ],
};

function OpenQuestion() {
  return <MeetGraph found={PRODUCT} />;
}

const SHOWN = { first: true, second: true };
const SHIFT: Shift = [1, 0, 1];

function SharedGrid() {
  const frame = useRef<HTMLDivElement>(null);
  const size = usePixels(frame);
  const grid = gridOf("gauss-2");
  const { system } = shapeOf(grid, "dragon");
  const boxes = useMemo(() => [boxOf(system), boxOf(system)] as const, [system]);
  const { layers } = useMeeting({ grid, first: system, second: system, shift: SHIFT, boxes, size });
  return (
    <div ref={frame} class={overlayCss["small"]}>
      <Drawing layers={layers} shown={SHOWN} isLine={false} />
    </div>
  );
}

export const THUMBS: Thumbs = {
  s1: { Thumb: FigureI },
  s2: { Thumb: FigureIi },
  s3: { Thumb: FigureIii },
  s4: { Thumb: FigureIv },
  s5: { Thumb: FigureV },
  s6: { Thumb: FigureVi },
  s7: { Thumb: FigureVii },
  s8: { Thumb: FigureViii },
  s34: { Thumb: Section34 },
  s35: { Thumb: Section35 },
  s9: { Thumb: OpenQuestion },
  s10: { Thumb: SharedGrid, needs: [loadDirected] },
};

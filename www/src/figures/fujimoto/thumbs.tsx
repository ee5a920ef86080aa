/** Small pictures of the figures of Fujimoto and others, by the addresses of their pages. */

import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { Box } from "#document/framing";
import type { MapRow3, SpaceView } from "#wasm/api";
import { SpaceDots } from "../darwish/space/space-dots";
import type { Thumbs } from "../figure";
import { Bent } from "../kit/picture/deformed";
import { Pair, Small } from "../kit/picture/small";
import { pieceOf, rightGasket } from "./codes/addresses";
import { GASKET, LIFT_BOX, liftOf } from "./deformations/lifted-gasket";
import { CubeSquare } from "./figure-1/cube-square";
import { Steps } from "./figure-2/address-steps";
import { Cell } from "./figure-3/shuffle-matrix";
import { FERN, swayOf } from "./figure-5/fern";
import { drawnOf, TWIN } from "./figure-6/drawn-dragon";

function Figure1() {
  return (
    <Small>
      <CubeSquare cube={{ dimensions: 2, parts: 2 }} letters={2} point={[0.62, 0.3]} label={null} />
    </Small>
  );
}

function Figure2() {
  return (
    <Small>
      <Steps
        r={0.55}
        depth={2}
        point={[0.5, 0]}
        here={[
          [0, 1],
          [1, 0],
        ].map((word) => pieceOf(rightGasket(0.55), word))}
        label={null}
      />
    </Small>
  );
}

function Figure3() {
  return (
    <Pair spaced>
      <Cell subject="square" chosen={{ kb: 0, ke: 3, superposed: false }} label={null} />
      <Cell subject="gasket" chosen={{ kb: 1, ke: 5, superposed: true }} label={null} />
    </Pair>
  );
}

function Figure4() {
  const bend = useMemo(() => bendAt(liftOf({ kb: 0 }), 1), []);
  return (
    <Small>
      <Bent maps={GASKET} box={LIFT_BOX} bend={bend} grid={0} label={null} />
    </Small>
  );
}

/** Where the fern is as it leans to a side. */
const LEANING: Box = { x0: -2.4, y0: -0.1, x1: 3.9, y1: 10.1 };

function Figure5() {
  const bend = useMemo(() => bendAt(swayOf({ kb: 0 }), 0.2), []);
  return (
    <Small shape={0.62}>
      <Bent maps={FERN} box={LEANING} bend={bend} aspect={0.62} grid={0} label={null} />
    </Small>
  );
}

/** Where the dragon is as it is drawn. */
const DRAWN: Box = { x0: -0.8, y0: -0.5, x1: 1.75, y1: 1.45 };

function Figure6() {
  const bend = useMemo(() => bendAt(drawnOf({ kb: 0 }), 0.8), []);
  return (
    <Small shape={1.3}>
      <Bent maps={TWIN} box={DRAWN} bend={bend} aspect={1.3} colouring="grid" grid={0} label={null} />
    </Small>
  );
}

/** Twenty thirds of a cube, those on top leaning to the side: of points, so that nothing is fetched. */
const LEANING_CUBE: MapRow3[] = [0, 1, 2].flatMap((z) =>
  [0, 1, 2].flatMap((y) =>
    [0, 1, 2]
      .filter((x) => [x, y, z].filter((k) => k === 1).length < 2)
      .map(
        (x): MapRow3 => [
          1 / 3,
          0,
          0.06 * z,
          0,
          1 / 3,
          0,
          0,
          0,
          1 / 3,
          (x - 1) / 1.5 + 0.18 * z,
          (y - 1) / 1.5,
          (z - 1) / 1.5,
        ],
      ),
  ),
);
const CUBE_VIEW: SpaceView = { target: [0.25, 0, 0], distance: 6, turn: 0.5, tilt: 0.42, angle: 0.62 };

const Section53 = () => <SpaceDots maps={LEANING_CUBE} view={CUBE_VIEW} />;

export const THUMBS: Thumbs = {
  d1: { Thumb: Figure1 },
  d2: { Thumb: Figure2 },
  d3: { Thumb: Figure3 },
  d4: { Thumb: Figure4 },
  d5: { Thumb: Figure5 },
  d6: { Thumb: Figure6 },
  d53: { Thumb: Section53 },
};

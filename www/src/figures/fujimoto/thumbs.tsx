/** Small pictures of the figures on fractal deformation, made by the same parts as the figures themselves. */
import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { Box } from "#document/framing";
import type { Bend, Colouring, MapRow } from "#wasm/api";
import { Bent } from "../kit/picture/deformed";
import { pieceOf, rightGasket } from "./codes/addresses";
import { CubeSquare } from "./figure-1/cube-square";
import { Steps } from "./figure-2/address-steps";
import { Cell } from "./figure-3/shuffle-matrix";
import { GASKET, LIFT_BOX, liftOf } from "./figure-4/page";
import { FERN, swayOf } from "./figure-5/page";
import { drawnOf, TWIN } from "./figure-6/page";

export function Codes() {
  return <CubeSquare cube={{ dimensions: 2, parts: 2 }} letters={2} point={[0.62, 0.3]} label={null} />;
}

export function Addresses() {
  return (
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
  );
}

export function Colours() {
  return (
    <span class="thumb-pair">
      <Cell subject="square" chosen={{ kb: 0, ke: 3, superposed: false }} label={null} />
      <Cell subject="gasket" chosen={{ kb: 1, ke: 5, superposed: true }} label={null} />
    </span>
  );
}

export function Lifted() {
  const bend = useMemo(() => bendAt(liftOf({ kb: 0 }), 1), []);
  return <Still maps={GASKET} box={LIFT_BOX} bend={bend} />;
}

/** Where the fern is as it leans to a side. */
const LEANING: Box = { x0: -2.4, y0: -0.1, x1: 3.9, y1: 10.1 };

export function Swaying() {
  const bend = useMemo(() => bendAt(swayOf({ kb: 0 }), 0.2), []);
  return <Still maps={FERN} box={LEANING} bend={bend} aspect={0.62} />;
}

/** Where the dragon is as it is drawn. */
const DRAWN: Box = { x0: -0.8, y0: -0.5, x1: 1.75, y1: 1.45 };

export function Drawn() {
  const bend = useMemo(() => bendAt(drawnOf({ kb: 0 }), 0.8), []);
  return <Still maps={TWIN} box={DRAWN} bend={bend} aspect={1.3} colouring="grid" />;
}

interface StillProps {
  maps: MapRow[];
  box: Box;
  bend: Bend;
  aspect?: number;
  colouring?: Colouring;
}

function Still(props: StillProps) {
  return <Bent {...props} grid={0} label={null} />;
}

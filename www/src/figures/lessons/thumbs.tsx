/** Small pictures of the lessons, by the addresses of their pages. */

import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import { UNIT } from "#geometry/boxes";
import type { Thumbs } from "../figure";
import { FAR_CORNER, GASKET, LIFT_BOX, liftOf } from "../fujimoto/deformations/lifted-gasket";
import { barnsley } from "../kit/connectedness/barnsley";
import { Rows } from "../kit/connectedness/barnsley-rows";
import { startRun } from "../kit/connectedness/buffer-run";
import { Buffer } from "../kit/connectedness/index-buffer";
import { Graph } from "../kit/connectedness/overlap-graph";
import { preset } from "../kit/frame/studio-link";
import { mapsOf } from "../kit/locus/set-m";
import { cutKoch, gasket, HEIGHT, PEAK, unevenGasket } from "../kit/maps/families";
import { STARTS } from "../kit/maps/iterates";
import { boxAround, mapsAt } from "../kit/maps/morphs";
import { apply, type Point } from "../kit/maps/pieces";
import { Drawn, PieceNames } from "../kit/picture/annotated";
import { Bent } from "../kit/picture/deformed";
import { Fitted } from "../kit/picture/fitted";
import { Iterates } from "../kit/picture/iterates";
import { Picture } from "../kit/picture/picture";
import { Pair, Small } from "../kit/picture/small";
import { Board } from "./lesson-2/board";
import { Throws } from "./lesson-2/throws";
import { flagPath, turned } from "./lesson-6/flag";
import flagCss from "./lesson-6/flag.module.css";
import { Matching } from "./lesson-10/matching";
import { orbit, pushing, repeated, turning } from "./lesson-14/orbit";
import { Track } from "./lesson-14/track";
import { play } from "./lesson-15/dice";
import { Shade } from "./lesson-15/shade";
import { TRIANGLE } from "./lesson-15/shapes";
import { boxesOf, GRIDDED } from "./lesson-17/boxes";
import { Counted } from "./lesson-17/counted";
import { Curve } from "./lesson-18/curve";
import { Chart } from "./lesson-20/chart";
import { useProved } from "./lesson-20/proved";
import { type Curve as CrossingCurve, pointsOf } from "./lesson-21/curves";
import crossingCss from "./lesson-21/square.module.css";
import { lifted } from "./lesson-22/answer";
import { Board as LeafBoard } from "./lesson-23/board";
import { GOOD } from "./lesson-23/collage";
import { SHADOW_BOX, SPONGE, shadowMaps } from "./lesson-24/shapes";
import { onCircle } from "./lesson-25/walk";
import { LEAF, rounded } from "./lesson-27/rounded";
import { SHAPE, turnedMaps } from "./lesson-28/turned";
import { LEVEL, tent } from "./lesson-29/hill";
import { lettersOf } from "./lesson-31/cells";
import { Field } from "./lesson-31/field";

const GASKET_MAPS = gasket(0.5);
const LETTER = { outlines: STARTS.letter };

/** A letter, and what becomes of it. */
function AnyStart() {
  return (
    <Pair>
      {[1, 4].map((steps) => (
        <Iterates key={steps} maps={GASKET_MAPS} steps={steps} start={LETTER} box={UNIT} label={null} />
      ))}
    </Pair>
  );
}

function Fern() {
  const { maps } = useMemo(() => preset("fern"), []);
  return <Fitted of={maps} />;
}

function Contraction() {
  const points = useMemo(() => orbit(repeated(turning(0.9, 25), 30), [1, 0.3]), []);
  return (
    <Small shape={4 / 3}>
      <Track points={points} reach={1.3} label={null} />
    </Small>
  );
}

function ThrownByHand() {
  const game = useMemo(() => {
    const thrown = new Throws();
    thrown.roll(700);
    return thrown;
  }, []);
  return (
    <Small shape={400 / 360}>
      <Board game={game} count={game.count} label={null} />
    </Small>
  );
}

const TRIANGLE_BOX = { x0: 0, y0: 0, x1: 1, y1: HEIGHT };
const MIDDLE: Point = [0.5, HEIGHT / 3];

function Addresses() {
  return (
    <Drawn maps={GASKET_MAPS} box={TRIANGLE_BOX} label={null}>
      {(place) => <PieceNames at={GASKET_MAPS.map((map) => place(apply(map, MIDDLE)))} />}
    </Drawn>
  );
}

const TARGET = lettersOf("13");
const THROWS = lettersOf("31");

function Target() {
  return <Field label={null} target={TARGET} throws={THROWS} size={1.6} />;
}

function UnevenDice() {
  const game = useMemo(() => play(GASKET_MAPS, [6, 3, 1], 40_000), []);
  return (
    <Small shape={4 / 3}>
      <Shade game={game} box={TRIANGLE} label={null} />
    </Small>
  );
}

const MEETING = { x0: 0.36, x1: 0.64, y0: -0.05, y1: 0.16 };

function TwoPieces() {
  return <Picture maps={GASKET_MAPS} box={MEETING} margin={0} label={null} />;
}

function Pixels() {
  const run = useMemo(() => {
    const started = startRun(gasket(0.49), 17, 3000);
    started.plotTo(3000);
    return started;
  }, []);
  return (
    <Small>
      <Buffer run={run} count={run.count} label={null} />
    </Small>
  );
}

/** Koch's curve over its graph. */
function OverlapGraph() {
  const maps = useMemo(() => cutKoch(0), []);
  const edges = [0, 1, 2].map((i) => ({ between: [i, i + 1] as [number, number], at: 0, pixel: 0 }));
  const angles = [Math.PI, Math.PI / 2, 0, -Math.PI / 2];
  return (
    <Pair>
      <Picture maps={maps} box={{ x0: 0, y0: 0, x1: 1, y1: PEAK }} label={null} />
      <Graph count={4} angles={angles} edges={edges} still />
    </Pair>
  );
}

const ALONE = unevenGasket([0.5, 0.5, 0.3]);

const ThirdPiece = () => <Fitted of={ALONE} />;

const BOX_LEVEL = 3;
const SIDE = 1 / 2 ** BOX_LEVEL;

function Boxes() {
  return (
    <Drawn maps={GRIDDED.gasket.maps} box={UNIT} label={null}>
      {(place) => <Counted boxes={boxesOf(GRIDDED.gasket, BOX_LEVEL)} side={SIDE} place={place} />}
    </Drawn>
  );
}

const RoughCurve = () => (
  <Small shape={400 / 250}>
    <Curve curve={{ heights: [0, 0.7, 0.3, 0.9, 0.2], factors: [0.4, 0.4, 0.4, 0.4] }} label={null} />
  </Small>
);

const Tent = () => (
  <Small shape={400 / 250}>
    <Curve curve={tent(LEVEL)} label={null} />
  </Small>
);

/** A letter that turns by quarters. */
function Turns() {
  return (
    <svg class={flagCss["flags"]} viewBox="0 0 210 76" aria-hidden="true">
      {[1, 0.5, 0].map((turn, i) => (
        <g key={turn} transform={`translate(${68 * i + 37} 38)`}>
          <circle r={32} class={flagCss["flag-ring"]} />
          <path class={flagCss["flag"]} d={flagPath(turned(Math.PI * turn, 0.5), 48)} />
        </g>
      ))}
    </svg>
  );
}

function Pairing() {
  return <Matching matching={[1, 0, 2]} wide />;
}

function MorphMap() {
  const { field } = useProved(true);
  return (
    <Small>
      <Chart field={field} label={null} />
    </Small>
  );
}

/** A moment of the led morph. */
function LedMorph() {
  const maps = useMemo(
    () => mapsAt({ from: preset("dragon-3").maps, to: preset("terdragon").maps }, [0.3, 0.6]),
    [],
  );
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}

const TAME = mapsOf([0.3, 0.6]);

const SetM = () => <Fitted of={TAME} />;

const SMALL_MAPS = mapsOf(onCircle(0.6, 88));

const Size = () => <Fitted of={SMALL_MAPS} />;

const WALK_MAPS = mapsOf(onCircle(0.68, 66));

const Walk = () => <Fitted of={WALK_MAPS} />;

function Bound() {
  return <Rows rounds={barnsley(0.49, 6)} r={0.49} bare />;
}

const CURVE_A: CrossingCurve = { from: 3.5, to: 1.5, swing: 0.25 };
const CURVE_B: CrossingCurve = { from: 0.35, to: 2.4, swing: -0.2 };
const crossingPath = (curve: CrossingCurve) =>
  `M${pointsOf(curve)
    .map(([x, y]) => `${(100 * x).toFixed(1)} ${(100 - 100 * y).toFixed(1)}`)
    .join("L")}`;

function CrossingCurves() {
  return (
    <Small>
      <svg viewBox="-4 -4 108 108" aria-hidden="true">
        <rect class={crossingCss["crossing-frame"]} width={100} height={100} />
        <path class={crossingCss["curve-a"]} d={crossingPath(CURVE_A)} />
        <path class={crossingCss["curve-b"]} d={crossingPath(CURVE_B)} />
      </svg>
    </Small>
  );
}

function Ruler() {
  const points = useMemo(() => orbit(repeated(pushing(0.6, 1.5), 12), [0, 1]), []);
  return (
    <Small shape={4 / 3}>
      <Track points={points} reach={1.05} middle={[0.13, 0.8]} label={null} />
    </Small>
  );
}

/** The far corner of a gasket that is pulled elsewhere. */
function FarCorner() {
  const bend = useMemo(() => bendAt(liftOf({ kb: 0 }), 1), []);
  return (
    <Small>
      <Bent maps={GASKET} box={FAR_CORNER} bend={bend} grid={0} label={null} />
    </Small>
  );
}

function Levels() {
  const bend = useMemo(() => lifted(2, 0.75), []);
  return (
    <Small>
      <Bent maps={GASKET} box={LIFT_BOX} bend={bend} grid={0} label={null} />
    </Small>
  );
}

function Cover() {
  return (
    <Small shape={4 / 3}>
      <LeafBoard copies={GOOD} label={null} />
    </Small>
  );
}

const ROUNDED_LEAF = rounded(LEAF, 3);

const RoundedLeaf = () => <Fitted of={ROUNDED_LEAF} />;

const EYE = { turn: 24, tilt: 14 };

function SpongeShadow() {
  const maps = useMemo(() => shadowMaps(SPONGE, EYE), []);
  return <Picture maps={maps} box={SHADOW_BOX} label={null} />;
}

function TurnedShape() {
  const maps = useMemo(() => shadowMaps(turnedMaps(SHAPE, 40), { turn: 0, tilt: 20 }), []);
  return <Picture maps={maps} box={SHADOW_BOX} label={null} />;
}

export const THUMBS: Thumbs = {
  e12: { Thumb: AnyStart },
  e13: { Thumb: Fern },
  e14: { Thumb: Contraction },
  e2: { Thumb: ThrownByHand },
  e16: { Thumb: Addresses },
  e31: { Thumb: Target },
  e15: { Thumb: UnevenDice },
  e1: { Thumb: TwoPieces },
  e5: { Thumb: Pixels },
  e3: { Thumb: OverlapGraph },
  e9: { Thumb: ThirdPiece },
  e17: { Thumb: Boxes },
  e18: { Thumb: RoughCurve },
  e29: { Thumb: Tent },
  e6: { Thumb: Turns },
  e10: { Thumb: Pairing },
  e20: { Thumb: MorphMap },
  e7: { Thumb: LedMorph },
  e8: { Thumb: SetM },
  e26: { Thumb: Size },
  e25: { Thumb: Walk },
  e4: { Thumb: Bound },
  e21: { Thumb: CrossingCurves },
  e30: { Thumb: Ruler },
  e11: { Thumb: FarCorner },
  e22: { Thumb: Levels },
  e23: { Thumb: Cover },
  e27: { Thumb: RoundedLeaf },
  e24: { Thumb: SpongeShadow },
  e28: { Thumb: TurnedShape },
};

/** Small pictures of the lessons, made by the same parts as the lessons themselves. */
import { useMemo } from "preact/hooks";
import { bendAt } from "#document/deform/bend";
import type { MapRow } from "#wasm/api";
import { startRun } from "../burch-hart/figure-2/page";
import { GASKET, liftOf } from "../fujimoto/figure-4/page";
import { barnsley } from "../kit/connectedness/barnsley";
import { Rows } from "../kit/connectedness/barnsley-rows";
import { Buffer } from "../kit/connectedness/index-buffer";
import { Graph } from "../kit/connectedness/overlap-graph";
import { preset } from "../kit/frame/studio-link";
import { mapsOf } from "../kit/locus/set-m";
import { cutKoch, gasket, PEAK, unevenGasket } from "../kit/maps/families";
import { boxAround, mapsAt } from "../kit/maps/morphs";
import { Bent } from "../kit/picture/deformed";
import { Picture } from "../kit/picture/picture";
import { Board } from "./lesson-2/board";
import { Throws } from "./lesson-2/throws";
import { flagPath, turned } from "./lesson-6/flag";
import { Matching } from "./lesson-10/matching";
import { FAR } from "./lesson-11/page";

const MEETING = { x0: 0.36, x1: 0.64, y0: -0.05, y1: 0.16 };

export function Meeting() {
  const maps = useMemo(() => gasket(0.5), []);
  return <Picture maps={maps} box={MEETING} margin={0} label={null} />;
}

export function Game() {
  const game = useMemo(() => {
    const thrown = new Throws();
    thrown.roll(700);
    return thrown;
  }, []);
  return <Board game={game} count={game.count} label={null} />;
}

/** Koch's curve over its graph. */
export function Net() {
  const maps = useMemo(() => cutKoch(0), []);
  const edges = [0, 1, 2].map((i) => ({ between: [i, i + 1] as [number, number], at: 0, pixel: 0 }));
  const angles = [Math.PI, Math.PI / 2, 0, -Math.PI / 2];
  return (
    <span class="thumb-pair">
      <Picture maps={maps} box={{ x0: 0, y0: 0, x1: 1, y1: PEAK }} label={null} />
      <Graph count={4} angles={angles} edges={edges} still />
    </span>
  );
}

export function Bars() {
  return <Rows rounds={barnsley(0.49, 6)} r={0.49} bare />;
}

export function Coarse() {
  const run = useMemo(() => {
    const started = startRun(gasket(0.49), 17, 3000);
    started.plotTo(3000);
    return started;
  }, []);
  return <Buffer run={run} count={run.count} label={null} />;
}

/** A letter that turns by quarters. */
export function Letters() {
  return (
    <svg class="flags" viewBox="0 0 210 76" aria-hidden="true">
      {[1, 0.5, 0].map((turn, i) => (
        <g key={turn} transform={`translate(${68 * i + 37} 38)`}>
          <circle r={32} class="flag-ring" />
          <path class="flag" d={flagPath(turned(Math.PI * turn, 0.5), 48)} />
        </g>
      ))}
    </svg>
  );
}

/** A moment of the led morph. */
export function Led() {
  const maps = useMemo(
    () => mapsAt({ from: preset("dragon-3").maps, to: preset("terdragon").maps }, [0.3, 0.6]),
    [],
  );
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}

export function Tame() {
  return <Fitted of={TAME} />;
}

const TAME = mapsOf([0.3, 0.6]);

export function Alone() {
  return <Fitted of={ALONE} />;
}

const ALONE = unevenGasket([0.5, 0.5, 0.3]);

function Fitted({ of: maps }: { of: MapRow[] }) {
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}

export function Paired() {
  return <Matching matching={[1, 0, 2]} />;
}

/** The far corner of a gasket that is pulled elsewhere. */
export function Far() {
  const bend = useMemo(() => bendAt(liftOf({ kb: 0 }), 1), []);
  return <Bent maps={GASKET} box={FAR} bend={bend} grid={0} label={null} />;
}

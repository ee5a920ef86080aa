/** Small pictures of the figures of Burch & Hart 1997, by the addresses of their pages. */

import { useEffect, useMemo } from "preact/hooks";
import { uvAt } from "#geometry/path";
import { directed, loadDirected } from "#wasm/directed";
import type { Thumbs } from "../figure";
import { barnsley } from "../kit/connectedness/barnsley";
import { Rows } from "../kit/connectedness/barnsley-rows";
import { startRun } from "../kit/connectedness/buffer-run";
import { Buffer } from "../kit/connectedness/index-buffer";
import { look } from "../kit/directed/look";
import { StatePicture } from "../kit/directed/state-picture";
import { Square } from "../kit/locus/locus-square";
import { gasket, turnedGasket } from "../kit/maps/families";
import { boxAround, mapsAt, STRAIGHT } from "../kit/maps/morphs";
import { Fitted } from "../kit/picture/fitted";
import { Picture } from "../kit/picture/picture";
import { Pair, Small } from "../kit/picture/small";
import { useValue } from "../kit/workers";
import { chart, ends, followChart } from "./dragon/dragon";

function Figure1() {
  return <Rows rounds={barnsley(0.47, 6)} r={0.47} bare />;
}

function Figure2() {
  const run = useMemo(() => {
    const started = startRun(gasket(0.5), 31, 900);
    started.plotTo(900);
    return started;
  }, []);
  return (
    <Small>
      <Buffer run={run} count={run.count} label={null} />
    </Small>
  );
}

/** The same moment both ways. */
function Figures3And4() {
  const pictures = useMemo(() => {
    const pair = { from: turnedGasket(), to: gasket(0.5) };
    const maps = (["linear", "polar"] as const).map((mode) => mapsAt(pair, [0.35, 0.35], mode));
    return { maps, box: boxAround(maps) };
  }, []);
  return (
    <Pair>
      {pictures.maps.map((maps, i) => (
        <Picture key={i === 0 ? "linear" : "polar"} maps={maps} box={pictures.box} label={null} />
      ))}
    </Pair>
  );
}

function Figure5() {
  const pair = useValue(ends);
  const maps = useMemo(() => mapsAt(pair, uvAt(STRAIGHT, 0.6)), [pair]);
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}

function Figure6() {
  const pair = useValue(ends);
  const points = useValue(chart).plan?.points ?? null;
  const maps = useMemo(() => (points ? mapsAt(pair, uvAt(points, 0.6)) : null), [pair, points]);
  const box = useMemo(() => boxAround(maps ? [maps] : []), [maps]);
  return maps && <Picture maps={maps} box={box} label={null} />;
}

function Figure7() {
  useEffect(followChart, []);
  const { field, plan } = chart.value;
  const lines = [
    { name: "straight", points: STRAIGHT, dashed: true },
    ...(plan ? [{ name: "planned", points: plan.points }] : []),
  ];
  return (
    <Small>
      <Square field={field} label={null} lines={lines} />
    </Small>
  );
}

const APART = gasket(0.47);

/** The gasket of which the table tells, with its pieces a little apart. */
const Table1 = () => <Fitted of={APART} />;

function Section7() {
  const system = useMemo(() => directed.directedPresets().find(({ id }) => id === "rauzy")?.system, []);
  const seen = useMemo(() => (system ? look(system) : null), [system]);
  if (!system || seen === null || typeof seen === "string") return null;
  const [box] = seen.boxes;
  return box ? <StatePicture system={system} state={0} box={box} level={0} label={null} /> : null;
}

export const THUMBS: Thumbs = {
  "1": { Thumb: Figure1 },
  "2": { Thumb: Figure2 },
  "3": { Thumb: Figures3And4 },
  "5": { Thumb: Figure5 },
  "6": { Thumb: Figure6 },
  "7": { Thumb: Figure7 },
  "table-1": { Thumb: Table1 },
  "section-7": { Thumb: Section7, needs: [loadDirected] },
};

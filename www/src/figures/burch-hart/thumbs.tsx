/** Small pictures of the figures, made by the same parts as the figures themselves. */
import { useEffect, useMemo } from "preact/hooks";
import { uvAt } from "#geometry/path";
import { barnsley } from "../kit/connectedness/barnsley";
import { Rows } from "../kit/connectedness/barnsley-rows";
import { Buffer as Pixels } from "../kit/connectedness/index-buffer";
import { Square } from "../kit/locus/locus-square";
import { gasket, turnedGasket } from "../kit/maps/families";
import { boxAround, mapsAt, STRAIGHT } from "../kit/maps/morphs";
import { Picture } from "../kit/picture/picture";
import { useValue } from "../kit/workers";
import { chart, ends, followChart } from "./dragon/dragon";
import { startRun } from "./figure-2/page";

export function Dust() {
  return <Rows rounds={barnsley(0.47, 6)} r={0.47} bare />;
}

export function Buffer() {
  const run = useMemo(() => {
    const started = startRun(gasket(0.5), 31, 900);
    started.plotTo(900);
    return started;
  }, []);
  return <Pixels run={run} count={run.count} label={null} />;
}

/** The same moment both ways. */
export function Turning() {
  const pictures = useMemo(() => {
    const pair = { from: turnedGasket(), to: gasket(0.5) };
    const maps = (["linear", "polar"] as const).map((mode) => mapsAt(pair, [0.35, 0.35], mode));
    return { maps, box: boxAround(maps) };
  }, []);
  return (
    <span class="thumb-pair">
      {pictures.maps.map((maps, i) => (
        <Picture key={i === 0 ? "linear" : "polar"} maps={maps} box={pictures.box} label={null} />
      ))}
    </span>
  );
}

export function Straight() {
  const pair = useValue(ends);
  const maps = useMemo(() => mapsAt(pair, uvAt(STRAIGHT, 0.6)), [pair]);
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}

export function Planned() {
  const pair = useValue(ends);
  const points = useValue(chart).plan?.points ?? null;
  const maps = useMemo(() => (points ? mapsAt(pair, uvAt(points, 0.6)) : null), [pair, points]);
  const box = useMemo(() => boxAround(maps ? [maps] : []), [maps]);
  return maps && <Picture maps={maps} box={box} label={null} />;
}

export function Locus() {
  useEffect(followChart, []);
  const { field, plan } = chart.value;
  const lines = [
    { name: "straight", points: STRAIGHT, dashed: true },
    ...(plan ? [{ name: "planned", points: plan.points }] : []),
  ];
  return <Square field={field} label={null} lines={lines} />;
}

/** The gasket of which the table tells, with its pieces a little apart. */
export function Accuracy() {
  const maps = useMemo(() => gasket(0.47), []);
  const box = useMemo(() => boxAround([maps]), [maps]);
  return <Picture maps={maps} box={box} label={null} />;
}

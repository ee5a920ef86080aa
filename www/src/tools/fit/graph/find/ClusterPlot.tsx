import { useLayoutEffect, useRef } from "preact/hooks";
import { dark } from "#document/preferences";
import type { HoughCluster } from "#workers/fit/hough";
import graphCss from "../graph.module.css";
import * as messages from "../messages";
import { errorWords, mapWords, nameOf } from "../model/graph-text";
import { choose, chosen, current, found, isPicked, live, search, togglePick } from "./search";

export type AxesId = "ac" | "principal";

const SIDE = 320;
const MIDDLE = SIDE / 2;
const EDGE = 14;
/** Radius of the cluster with most hits. */
const LARGEST = 26;
const SMALLEST = 2.5;
/** Bins of a and c each. */
const BINS = 128;

/** Clusters as circles, as large as they have hits (Fig 5), over what was counted. */
export function ClusterPlot({ axes }: { axes: AxesId }) {
  const list = live.value || !current.value ? [] : found.value;
  const extents = extentsOf(list, axes);
  const most = Math.max(1, ...list.map(({ hits }) => hits));
  const selected = chosen.value;
  const active = selected === null ? undefined : `cluster-${selected}`;
  // The largest first, so that small ones lie on top.
  return (
    <div class={graphCss["cluster-plot"]}>
      {axes === "ac" && <Plane />}
      <div
        class={graphCss["cluster-list"]}
        role="listbox"
        aria-label={messages.clustersBy(
          axes === "ac" ? messages.theirScalesAndC : messages.theirMainDirections,
        )}
        aria-activedescendant={active}
        tabIndex={0}
        onKeyDown={onKey}
      >
        <svg viewBox={`0 0 ${SIDE} ${SIDE}`} role="presentation">
          <path
            class={graphCss["cluster-axes"]}
            d={`M${EDGE} ${MIDDLE}H${SIDE - EDGE}M${MIDDLE} ${EDGE}V${SIDE - EDGE}`}
          />
          <text class={graphCss["cluster-axis"]} x={SIDE - EDGE} y={MIDDLE - 5} text-anchor="end">
            {axes === "ac" ? "a" : "1st"}
          </text>
          <text class={graphCss["cluster-axis"]} x={MIDDLE + 5} y={EDGE + 8}>
            {axes === "ac" ? "c" : "2nd"}
          </text>
          {list.map((cluster, index) => {
            const [left, top] = placeOf(cluster, axes, extents);
            const radius = Math.max(SMALLEST, LARGEST * Math.sqrt(cluster.hits / most));
            return (
              <g
                key={index}
                id={`cluster-${index}`}
                class={`${graphCss["cluster"]} ${index === selected ? graphCss["chosen"] : ""} ${isPicked(index) ? graphCss["picked"] : ""}`}
                data-kind={cluster.kind}
                role="option"
                aria-selected={index === selected}
                aria-label={messages.clusterIs(
                  nameOf(cluster, index),
                  cluster.hits,
                  isPicked(index) ? messages.pickedAside : "",
                  mapWords(cluster.map),
                  errorWords(cluster),
                )}
                transform={`translate(${left.toFixed(1)} ${top.toFixed(1)})`}
                onClick={() => choose(index)}
                onDblClick={() => togglePick(index)}
              >
                <circle class={graphCss["reach"]} r={Math.max(radius, 9)} />
                <circle class={graphCss["spot"]} r={radius} />
                {radius >= 8 && cluster.kind !== "clutter" && (
                  <text dy="0.35em" text-anchor="middle">
                    {index + 1}
                  </text>
                )}
              </g>
            );
          })}
        </svg>
      </div>
    </div>
  );
}

function onKey(event: KeyboardEvent): void {
  const all = found.peek().length;
  if (all === 0 || event.ctrlKey || event.metaKey || event.altKey) return;
  const now = chosen.peek();
  const by: Record<string, number> = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 };
  const step = by[event.key];
  if (step !== undefined) choose(now === null ? 0 : (now + step + all) % all);
  else if (event.key === "Home") choose(0);
  else if (event.key === "End") choose(all - 1);
  else if (event.key === "Enter" || event.key === " ") {
    if (now !== null) togglePick(now);
  } else return;
  event.preventDefault();
}

function extentsOf(list: readonly HoughCluster[], axes: AxesId): [number, number] {
  if (axes === "ac") return [1, 1];
  const most = (i: 0 | 1) => Math.max(1e-6, ...list.map(({ place }) => Math.abs(place[i])));
  // One measure for both directions: how far clusters spread is what is shown.
  const both = Math.max(most(0), most(1));
  return [both, both];
}

function placeOf(cluster: HoughCluster, axes: AxesId, [across, up]: [number, number]): [number, number] {
  const [x, y] = axes === "ac" ? [cluster.at[0], cluster.at[2]] : [cluster.place[0], cluster.place[1]];
  const half = MIDDLE - EDGE;
  return [MIDDLE + (half * x) / across, MIDDLE - (half * y) / up];
}

/** What is counted so far: the hits of each a and c, the most of any b. */
function Plane() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const plane = live.value ?? (current.value ? search.value?.plane : undefined);
  // The ink is that of the theme.
  const ink = dark.value ? 0xeceae4 : 0x1d1e22;
  useLayoutEffect(() => {
    const context = canvas.current?.getContext("2d");
    if (!context) return;
    const image = context.createImageData(BINS, BINS);
    let most = 1;
    for (const hits of plane ?? []) if (hits > most) most = hits;
    const colour = [ink >> 16, (ink >> 8) & 255, ink & 255];
    for (let a = 0; plane && a < BINS; a++) {
      for (let c = 0; c < BINS; c++) {
        const at = 4 * ((BINS - 1 - c) * BINS + a);
        image.data.set(colour, at);
        // The fourth root: else the few largest are all that is seen.
        image.data[at + 3] = 110 * ((plane[a * BINS + c] ?? 0) / most) ** 0.25;
      }
    }
    context.putImageData(image, 0, 0);
  }, [plane, ink]);
  return <canvas ref={canvas} width={BINS} height={BINS} />;
}

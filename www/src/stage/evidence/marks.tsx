/** What proves the verdict, drawn over the picture. */
import { computed } from "@preact/signals";
import { proof } from "#compute/proof";
import { verdict } from "#compute/results";
import { shareOf, shareWords, stateOf } from "#format/verdict";
import { toScreen, world } from "#geometry/coordinates";
import { STATE } from "#geometry/states";
import type { Certificate, Connectedness, Link, MapRow } from "#wasm/api";
import { stageStyle } from "../picture-style";
import css from "../stage.module.css";
import { effectiveView, stageSize } from "../view";
import { evidenceMarked } from "./shown";

/** Links that are drawn; more would hide the picture that they are about. */
const MOST_LINKS = 150;
/** Pieces of a proof that are drawn. */
const MOST_HULLS = 400;

/** The least length of a chord on the stage. */
const SHORTEST = 16;

type Point = { x: number; y: number };
const place = ([x, y]: readonly [number, number]): Point =>
  toScreen(world(x, y), effectiveView.value, stageSize.value);

/** Over the picture: where the widest gap is, and, where asked for, what holds the pieces together or apart. */
export function Evidence() {
  const answer = verdict.value;
  if (!answer || answer.stale) return null;
  const { width, height } = stageSize.value;
  const marked = evidenceMarked.value;
  const { connectedness, epsilon } = answer;
  return (
    <svg class="overlay quiet" width={width} height={height} aria-hidden="true">
      {marked && <Hulls />}
      {marked && <Links links={connectedness.reason?.links ?? []} />}
      <Gap answer={connectedness} epsilon={epsilon} marked={marked} />
    </svg>
  );
}

/** The two points that are nearest across the widest gap, and how far apart they are. */
function Gap({ answer, epsilon, marked }: { answer: Connectedness; epsilon: number; marked: boolean }) {
  const { closest } = answer;
  const broken = stateOf(answer, epsilon) === STATE.disconnected;
  // A gap that cannot be seen is only shown to those who ask.
  if (!closest || !(broken || (marked && answer.verdict === "disconnected"))) return null;
  const p = place(closest.from);
  const q = place(closest.to);
  const middle = { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 };
  const radius = Math.max(9, Math.hypot(q.x - p.x, q.y - p.y) / 2 + 6);
  return (
    <g>
      <line class={css["gap-halo"]} x1={p.x} y1={p.y} x2={q.x} y2={q.y} />
      <line class={css["gap-line"]} x1={p.x} y1={p.y} x2={q.x} y2={q.y} />
      {/* The ends stand off a little, so that the points themselves stay free. */}
      <circle class={css["gap-ring"]} cx={middle.x} cy={middle.y} r={radius} />
      <text class={`${css["gap-label"]} ${css["cased"]}`} x={middle.x + radius + 6} y={middle.y + 4}>
        {shareWords(shareOf(answer))}
      </text>
    </g>
  );
}

function Links({ links }: { links: readonly Link[] }) {
  const { palette } = stageStyle.value;
  const colourOf = (map: number) => palette[map % palette.length] ?? "currentColor";
  return (
    <g>
      {links.slice(0, MOST_LINKS).map((link) => {
        const key = `${link.kind} ${link.pair.join()} ${link.words.join()}`;
        const [p1, p2, q1, q2] = link.corners ?? [];
        const crossing = link.kind === "crossing" && p1 && p2 && q1 && q2;
        // Chords that are too short to be seen as such are a place like any other.
        if (crossing && Math.max(lengthOf(p1, p2), lengthOf(q1, q2)) >= SHORTEST)
          return (
            <g key={key}>
              <Chord from={p1} to={p2} colour={colourOf(link.pair[0])} />
              <Chord from={q1} to={q2} colour={colourOf(link.pair[1])} />
            </g>
          );
        const { x, y } = place(link.at);
        return (
          <g key={key} transform={`translate(${x.toFixed(1)} ${y.toFixed(1)})`}>
            <circle class={css["link-halo"]} r={6} />
            <circle class="link-ring" r={6} />
          </g>
        );
      })}
    </g>
  );
}

/** In CSS pixels. */
function lengthOf(from: [number, number], to: [number, number]): number {
  const p = place(from);
  const q = place(to);
  return Math.hypot(q.x - p.x, q.y - p.y);
}

function Chord({ from, to, colour }: { from: [number, number]; to: [number, number]; colour: string }) {
  const p = place(from);
  const q = place(to);
  const ends = { x1: p.x, y1: p.y, x2: q.x, y2: q.y };
  return (
    <g>
      <line class={css["chord-halo"]} {...ends} />
      <line class="chord" {...ends} style={{ stroke: colour }} />
      <circle class={css["chord-end"]} cx={p.x} cy={p.y} r={2.5} />
      <circle class={css["chord-end"]} cx={q.x} cy={q.y} r={2.5} />
    </g>
  );
}

interface Hull {
  side: 0 | 1;
  corners: [number, number][];
}

/** The pieces that a proof keeps apart: each holds all of its copy of the shape. */
export function hullsOf({ maps, polygon, pairs, side }: Certificate): Hull[] {
  const words = new Map<string, number[]>();
  for (const { u, v } of pairs) {
    words.set(u.join(), u);
    words.set(v.join(), v);
  }
  // A word of no letters is the whole, which nothing is apart from.
  const all = [...words.values()].filter((word) => word.length > 0);
  return all.map((word) => ({
    side: side[word[0] ?? 0] ?? 0,
    corners: polygon.map((corner) => word.reduceRight((p, letter) => image(maps[letter], p), corner)),
  }));
}

function image(map: MapRow | undefined, [x, y]: [number, number]): [number, number] {
  if (!map) return [x, y];
  const [a, b, c, d, e, f] = map;
  return [a * x + b * y + e, c * x + d * y + f];
}

/** Those that are marked now. */
export const hulls = computed(() => {
  const now = proof.value;
  // Pieces that hold together are shown by what holds them.
  if (now?.state !== "there" || !now.check.valid || "links" in now.certificate) return [];
  const found = hullsOf(now.certificate);
  return found.length > MOST_HULLS ? [] : found;
});

function Hulls() {
  return (
    <g>
      {hulls.value.map(({ side, corners }, i) => (
        <path
          // The pieces of one proof never change their order.
          key={i}
          class={side === 0 ? css["hull"] : `${css["hull"]} ${css["other"]}`}
          d={`M${corners
            .map(place)
            .map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`)
            .join("L")}Z`}
        />
      ))}
    </g>
  );
}

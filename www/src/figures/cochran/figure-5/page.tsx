import { useMemo } from "preact/hooks";
import { dark } from "#document/preferences";
import { fixed } from "#format/numbers";
import { palette } from "#style/palette";
import { TABLE_3 as TABLE_3_GRAPH } from "#tools/fit/graph/printed";
import { Switch } from "#ui/controls/Switch";
import type { HoughCluster } from "#workers/fit/hough";
import { QUARTERS } from "../../kit/chart/scale";
import { SliderControl } from "../../kit/frame/control";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { fitHref } from "../../kit/frame/studio-link";
import { tex } from "../../kit/notation/tex";
import { flag, whole } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { useValue } from "../../kit/workers";
import { cornerImages, heightsOf, TOP } from "../graphs/arrowhead";
import { stepFor } from "../graphs/graphs";
import { applied, COUNTED, type ShearMap } from "../graphs/printed-tables";
import { type Dots, Profile } from "../graphs/profile";
import { KIND_COLOURS, kindWords } from "../votes/cluster-names";
import { countWords, VoteProgress } from "../votes/vote-progress";
import { type Election, useVotes } from "../votes/votes";
import css from "./page.module.css";

const COARSE = 3;
const FINE = 4;
/** Clusters in the pictures. */
const TOP_100 = 100;
/** The widest circle, in pixels. */
const WIDEST = 30;
const REACH = 0.8;
const LETTERS = "abcde";

function hiddenVariable(): Election {
  const [coarse, fine] = [COARSE, FINE].map((depth) => heightsOf(cornerImages(depth), TOP)) as [
    Float64Array,
    Float64Array,
  ];
  return { name: "hidden variable", sets: { coarse, fine }, reflected: true };
}

/** What stands in its address. */
export const STATE = {
  cluster: kept(0, whole(0, TOP_100 - 1)),
  refined: kept(false, flag),
};

/** The clusters of votes for the function of Figure 4, from four sides. */
export function Page(heading: Heading) {
  const election = useMemo(hiddenVariable, []);
  const voting = useVotes(election);
  const [chosen, setChosen] = useKept("cluster", ...STATE.cluster);
  const [refined, setRefined] = useKept("refined", ...STATE.refined);
  const space = voting.outcome?.clusters.space ?? null;
  const found = useMemo(() => voting.outcome?.clusters.found.slice(0, TOP_100) ?? [], [voting.outcome]);
  const index = Math.min(chosen, Math.max(0, found.length - 1));
  const cluster = found[index];
  const most = Math.max(1, ...found.map(({ hits }) => hits));
  const spread =
    1.12 * Math.max(0.1, ...found.flatMap(({ place }) => [Math.abs(place[0]), Math.abs(place[1])]));
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The function of Figure 4 votes for its own maps. Each bar is a heap of votes, the highest first;
          step through them and see what each map does to the graph. Some say something new, many only repeat
          the others in other words. That shows best from the side: in a space of five dimensions the heaps
          lie in a few rows.
        </p>
      }
      found={
        space ? (
          <p>
            In the space of the five numbers {percent(space.shares[0] + space.shares[1])} of the spread lies
            along two directions, and {percent(space.shares[0] + space.shares[1] + space.shares[2])} along
            three. The paper’s authors had seen this in first experiments and wished for a picture of it; it
            is the one at the lower right. Of the {found.length} clusters {countOf(found, "map")} are maps,{" "}
            {countOf(found, "echo")} echoes of stronger ones.
          </p>
        ) : (
          <p>Counting …</p>
        )
      }
      parameters={[
        { name: "Feature points, domains and ranges", value: "55 and 163" },
        { name: "Mirrored maps", value: "tried, too" },
        { name: "Votes in the paper", value: countWords(COUNTED.figure5) },
        { name: "Votes here", value: voting.outcome ? countWords(voting.outcome.votes) : "…" },
        ...(cluster
          ? [
              {
                name: `Cluster ${index + 1}`,
                symbol: tex`a, b, c, d, e`,
                value: cluster.map.map((x) => fixed(x, 3)).join(", "),
              },
              { name: "What it is", value: kindWords(cluster, index) },
            ]
          : []),
        ...(space
          ? space.axes.slice(0, 2).map((axis, i) => ({
              name: i === 0 ? "First direction" : "Second direction",
              value: axisWords(axis),
            }))
          : []),
      ]}
      captions={[
        "Figure 5: Top: Histogram of the top 100 clusters. Middle: Feature points and a contracted image under the most popular map. (The slight misalignment is due to quantization error.) Bottom: Projection of 5-D hash table for parameters −0.8 ≤ a, c ≤ +0.8. (The size of each circle indicates the popularity of the associated parameters.)",
      ]}
      reconstructed="The function is that of Figure 4, rebuilt. The total of the paper’s votes is printed; the edges of its bins and the votes of each cluster are not. What spills over into bins beside a higher one is left out here, as the paper proposes."
      studio={{ href: fitHref({ mode: "graph", graph: TABLE_3_GRAPH }), label: "Open in the Fit tool" }}
    >
      <VoteProgress voting={voting} />
      <Panel>
        <Profile
          label={`Hits of the ${found.length} most popular clusters, from ${countWords(found[0]?.hits ?? 0)} down`}
          x={BARS}
          y={{ min: 0, max: 1.2 * most, ticks: ticksTo(most), format: countWords, name: "hits" }}
          height={210}
          lines={found.map(({ hits, kind }, i) => ({
            points: [i, 0, i, hits],
            colour: i === index ? "ink" : KIND_COLOURS[kind],
            width: i === index ? 4 : 2,
          }))}
        >
          {(place) => <Pick found={found} onPick={setChosen} place={(_, i) => [place(i, 0)[0], null]} />}
        </Profile>
        <ul class={layout["key"]} aria-label="Key">
          <Key kind="map" about="a map of its own" />
          <Key kind="echo" about="an echo of stronger ones" />
          <Key kind="clutter" about="clutter" />
        </ul>
      </Panel>
      <div class={layout["controls"]}>
        <SliderControl
          label="cluster"
          symbol="rank"
          range={[1, Math.max(2, found.length)]}
          whole
          value={index + 1}
          text={cluster ? `${index + 1}, ${countWords(cluster.hits)} hits` : "–"}
          valueText={
            cluster
              ? `cluster ${index + 1}, ${kindWords(cluster, index)}, ${countWords(cluster.hits)} hits`
              : "none yet"
          }
          onChange={(next) => setChosen(next - 1)}
        />
        <Switch checked={refined} onChange={setRefined}>
          Refine it by least squares
        </Switch>
      </div>
      <Image cluster={cluster} election={election} refined={refined} index={index} />
      <div class={layout["fit-columns"]}>
        <Panel caption="roughness c over width a; the larger the circle the more votes">
          <Profile
            label={`The clusters over a and c, from −0.8 to 0.8; cluster ${index + 1} is marked`}
            x={{ min: -REACH, max: REACH, ticks: [-0.8, -0.4, 0, 0.4, 0.8], name: "a" }}
            y={{ min: -REACH, max: REACH, ticks: [-0.8, -0.4, 0, 0.4, 0.8], name: "c" }}
            height={300}
            lines={CROSS}
            dots={circles(found, index, most, ({ map }) => [map[0], map[2]])}
          >
            {(place) => <Pick found={found} onPick={setChosen} place={({ map }) => place(map[0], map[2])} />}
          </Profile>
        </Panel>
        <Panel caption="the two directions in which the five numbers spread most">
          <Profile
            label={`The clusters along the two principal components; cluster ${index + 1} is marked`}
            x={{ min: -spread, max: spread, ticks: [0], name: "first direction" }}
            y={{ min: -spread, max: spread, ticks: [0], name: "second direction" }}
            height={300}
            lines={[]}
            dots={circles(found, index, most, ({ place }) => [place[0], place[1]])}
          >
            {(place) => (
              <Pick found={found} onPick={setChosen} place={(one) => place(one.place[0], one.place[1])} />
            )}
          </Profile>
        </Panel>
      </div>
    </Frame>
  );
}

const BARS = {
  min: -1,
  max: TOP_100,
  ticks: [0, 24, 49, 74, 99],
  format: (i: number) => String(i + 1),
};
const CROSS = [
  { points: [-REACH, 0, REACH, 0], colour: "quiet", width: 0.5 },
  { points: [0, -REACH, 0, REACH], colour: "quiet", width: 0.5 },
] as const;

function ticksTo(most: number): number[] {
  const step = stepFor(most);
  return Array.from({ length: Math.floor(most / step) + 1 }, (_, i) => i * step);
}

function countOf(found: readonly HoughCluster[], kind: HoughCluster["kind"]): number {
  return found.filter((cluster) => cluster.kind === kind).length;
}

function percent(part: number): string {
  return `${Math.round(100 * part)}%`;
}

/** A direction by its largest parts. */
function axisWords(axis: readonly number[]): string {
  return axis
    .map((x, i) => ({ x, name: LETTERS[i] ?? "" }))
    .filter(({ x }) => Math.abs(x) >= 0.2)
    .map(({ x, name }, i) => `${x < 0 ? "− " : i > 0 ? "+ " : ""}${fixed(Math.abs(x))} ${name}`)
    .join(" ");
}

function circles(
  found: readonly HoughCluster[],
  chosen: number,
  most: number,
  at: (cluster: HoughCluster) => [number, number],
): Dots[] {
  const sizeOf = ({ hits }: HoughCluster) => Math.max(3, WIDEST * Math.sqrt(hits / most));
  const dots = found.map((cluster): Dots => {
    return { points: at(cluster), colour: KIND_COLOURS[cluster.kind], size: sizeOf(cluster), hollow: true };
  });
  const cluster = found[chosen];
  if (cluster) {
    const mark = { points: at(cluster), colour: "ink" } as const;
    dots.push({ ...mark, size: sizeOf(cluster) + 7, hollow: true }, { ...mark, size: 5 });
  }
  return dots;
}

interface PickProps {
  found: readonly HoughCluster[];
  /** Where each is; without a height only the way across counts. */
  place: (cluster: HoughCluster, index: number) => [left: number, top: number | null];
  onPick: (index: number) => void;
}

/** Pressing chooses the nearest cluster; keys have the slider. */
function Pick({ found, place, onPick }: PickProps) {
  return (
    <div
      class={css["pick-reach"]}
      onPointerDown={(event) => {
        const box = event.currentTarget.getBoundingClientRect();
        const [px, py] = [event.clientX - box.left, event.clientY - box.top];
        const far = found.map((cluster, i) => {
          const [left, top] = place(cluster, i);
          return Math.hypot(left - px, top === null ? 0 : top - py);
        });
        const least = Math.min(...far);
        if (least < WIDEST) onPick(far.indexOf(least));
      }}
    />
  );
}

interface ImageProps {
  cluster: HoughCluster | undefined;
  index: number;
  election: Election;
  refined: boolean;
}

/** The feature points, and those that the map has a place for after it has moved them. */
function Image({ cluster, index, election: { sets }, refined }: ImageProps) {
  const map: ShearMap | undefined = refined ? (cluster?.candidate?.map ?? cluster?.map) : cluster?.map;
  const domain = cluster?.candidate?.domain;
  const moved: number[] = [];
  const source: number[] = [];
  for (let i = 0; map && i + 1 < sets.coarse.length; i += 2) {
    const [t, x] = [sets.coarse[i] ?? 0, sets.coarse[i + 1] ?? 0];
    if (domain && (t < domain[0] - 1e-9 || t > domain[1] + 1e-9)) continue;
    source.push(t, x);
    moved.push(...applied(map, [t, x]));
  }
  return (
    <Panel
      caption={
        cluster
          ? `Cluster ${index + 1}, ${kindWords(cluster, index)}: the blue points go to the rings.${
              refined
                ? ""
                : " That rings miss the graph a little is due to the bins, which are as wide as that."
            }`
          : "The feature points."
      }
    >
      <Profile
        label={
          cluster
            ? `The feature points, and ${moved.length / 2} of them moved by the map of cluster ${index + 1}`
            : "The feature points"
        }
        x={{ ...QUARTERS, name: "t" }}
        y={{ min: -0.05, max: 1.05, ticks: [0, 0.5, 1], name: "x" }}
        height={260}
        lines={[{ points: sets.fine, colour: "quiet", width: 0.75 }]}
        dots={[
          { points: sets.fine, colour: "quiet", size: 3 },
          { points: source, colour: 1, size: 4 },
          { points: moved, colour: 5, size: 7, hollow: true },
        ]}
      />
    </Panel>
  );
}

function Key({ kind, about }: { kind: keyof typeof KIND_COLOURS; about: string }) {
  const colours = palette(useValue(dark) ? "dark" : "light");
  return (
    <li>
      <i class={css["swatch"]} style={{ color: colours[KIND_COLOURS[kind]] }} /> {about}
    </li>
  );
}

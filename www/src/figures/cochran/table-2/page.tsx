import { useMemo } from "preact/hooks";
import { fixed } from "#format/numbers";
import { TABLE_1 as TABLE_1_GRAPH } from "#tools/fit/graph/printed";
import { Switch } from "#ui/controls/Switch";
import type { HoughCluster } from "#workers/fit/hough";
import { Frame, type Heading } from "../../kit/frame/frame";
import layout from "../../kit/frame/layout.module.css";
import { Panel } from "../../kit/frame/panel";
import { fitHref } from "../../kit/frame/studio-link";
import { flag } from "../../kit/state/fields";
import { kept, useKept } from "../../kit/state/kept";
import { fixedPointImages } from "../graphs/graphs";
import { MapTable } from "../graphs/map-table";
import { COUNTED, TABLE_1, TABLE_2 } from "../graphs/printed-tables";
import { kindWords, letterOf, nearestOf } from "../votes/cluster-names";
import { countWords, VoteProgress } from "../votes/vote-progress";
import { type Election, type Outcome, useVotes } from "../votes/votes";
import { VotePlane } from "./vote-plane";

/** Rows of the table here. */
const SHOWN = 10;
const COARSE = 6;
const FINE = 7;
/** Triples of the coarse points: no map can have more votes. */
const MOST_HITS = (65 * 64 * 63) / 6;

/** The words of the printed rows: compositions of the maps of Table 1. */
const WORDS = ["T₁ itself", "T₂ itself", "echo: T₂ T₁ T₂⁻¹", "echo: T₁ T₁ T₂⁻¹", "echo: T₁ T₂ T₁⁻¹"];

/** What stands in its address. */
export const STATE = {
  mirrored: kept(false, flag),
};

/** The maps of Table 1, found again by voting. */
export function Page(heading: Heading) {
  const [reflected, setReflected] = useKept("mirrored", ...STATE.mirrored);
  const election = useMemo((): Election => {
    const [coarse, fine] = [COARSE, FINE].map((depth) =>
      Float64Array.from(fixedPointImages(TABLE_1, depth).flat()),
    ) as [Float64Array, Float64Array];
    return { name: `table 1, reflected ${reflected}`, sets: { coarse, fine }, reflected };
  }, [reflected]);
  const voting = useVotes(election);
  const found = voting.outcome?.clusters.found ?? [];
  return (
    <Frame
      {...heading}
      lead={
        <p>
          The maps are lost, and only points of the graph are left. So let the points vote: take three of 65,
          and three of 129 that could be their image; there is one map that does it. That is one vote. Chance
          scatters, but a map that the graph is really made of is named again and again. Watch the votes heap
          up.
        </p>
      }
      found={<Found outcome={voting.outcome} />}
      parameters={[
        { name: "Points, domains and ranges", value: "65 and 129, images of the fixed points" },
        { name: "Bins of a, b, c", value: "128 × 128 × 128" },
        { name: "Bins of d, e", value: "256 × 256 for each of 100 places" },
        { name: "Mirrored maps", value: reflected ? "tried, too" : "not tried" },
        { name: "Least |a| and |c|", value: "0.15: smaller is clutter" },
        { name: "Most votes possible for a map", value: countWords(MOST_HITS) },
        { name: "Votes in the paper", value: countWords(COUNTED.table2) },
        { name: "Votes here", value: voting.outcome ? countWords(voting.outcome.votes) : "…" },
      ]}
      captions={["Table 2: Five most popular parameter clusters for Figure 2."]}
      reconstructed="Where the edges of the paper’s bins are, and which triples it counted, is not printed; so the hits differ, and of two maps that nearly every triple votes for, either may be first."
      differs="The paper’s total of 38,519,585 votes does not follow from its three conditions, which allow many more. It leaves small |a| in the table’s reach; without a lower bound such clutter, which almost everything votes for, fills the ranks."
      studio={{ href: fitHref({ mode: "graph", graph: TABLE_1_GRAPH }), label: "Open in the Fit tool" }}
    >
      <VoteProgress voting={voting} />
      <div class={layout["two-columns"]}>
        <MapTable
          caption={`The ${SHOWN} most popular maps here`}
          first="Rank"
          before={["hits"]}
          behind={["what it is", "Table 2"]}
          rows={found.slice(0, SHOWN).map((cluster, i) => ({
            name: `#${i + 1}`,
            map: cluster.map,
            before: [countWords(cluster.hits)],
            behind: [kindWords(cluster, i, (index) => letterOf(found, index)), printedRank(cluster)],
            quiet: cluster.kind === "clutter",
          }))}
        />
        <Panel caption="votes over a and c, the darker the more">
          <VotePlane
            plane={voting.plane}
            label="Votes over a, from left to right, and c, upwards; the darker the more."
          />
        </Panel>
      </div>
      <div class={layout["controls"]}>
        <Switch checked={reflected} onChange={setReflected}>
          Try mirrored maps, too
        </Switch>
      </div>
      <MapTable
        caption="Table 2, as printed"
        first="Rank"
        before={["hits"]}
        behind={["what it is", "found here as"]}
        rows={TABLE_2.map(({ hits, map }, i) => ({
          name: `#${i + 1}`,
          map,
          before: [countWords(hits)],
          behind: [WORDS[i], hereRank(found, i)],
        }))}
      />
    </Frame>
  );
}

function printedRank(cluster: HoughCluster): string {
  const row = nearestOf(
    cluster.map,
    TABLE_2.map(({ map }) => map),
  );
  return row === null ? "–" : `#${row + 1}`;
}

function hereRank(found: readonly HoughCluster[], row: number): string {
  if (found.length === 0) return "…";
  const map = TABLE_2[row]?.map;
  const index = map
    ? nearestOf(
        map,
        found.map((cluster) => cluster.map),
      )
    : null;
  return index === null ? "–" : `#${index + 1}, ${countWords(found[index]?.hits ?? 0)} hits`;
}

function Found({ outcome }: { outcome: Outcome | null }) {
  if (!outcome) return <p>Counting …</p>;
  const { found } = outcome.clusters;
  const maps = TABLE_1.map(({ map }) => map);
  const refined = maps.map((map) => {
    const cluster = found.find((one) => nearestOf(one.map, [map]) !== null);
    return cluster?.candidate ?? null;
  });
  const off = refined.map((candidate, i) =>
    candidate ? Math.max(...candidate.map.map((x, k) => Math.abs(x - (maps[i]?.[k] ?? 0)))) : null,
  );
  const echoes = found.slice(0, SHOWN).filter(({ kind }) => kind === "echo").length;
  return (
    <p>
      {off.every((one) => one !== null)
        ? `Both maps of Table 1 are found; once their bins are refined by least squares they are off by ${offWords(Math.max(...off.map((one) => one ?? 0)))}. `
        : "Not both maps of Table 1 are found. "}
      Of the {SHOWN} most popular {echoes} are echoes: where a graph is made of copies by T₁ and T₂, parts of
      it are also copies by one after the other, or after the other is undone, which T⁻¹ stands for. The paper
      noticed such echoes; here each is told what it is composed of.
    </p>
  );
}

function offWords(off: number): string {
  return off < 5e-5 ? "less than 0.0001" : `${fixed(off, 4)} at most`;
}

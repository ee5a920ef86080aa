import { FindSection } from "./find/Find";
import { FoundSection } from "./find/Found";
import { choose, chosen, current, found, running } from "./find/search";
import css from "./graph.module.css";
import * as messages from "./messages";
import { countWords, nameOf } from "./model/graph-text";
import { series } from "./model/series";
import { FunctionSection } from "./Pieces";

/** The other half of the tool: the graph of a function, made by hand or found in what is measured. */
export { GraphStage } from "./stage/GraphStage";

/** The function by hand, and how one is found in what is measured. */
export function GraphPanel() {
  return (
    <div class={css["fit-graph-panel"]}>
      <FindSection />
      <FoundSection />
      <FunctionSection />
    </div>
  );
}

const WIDTH = 1000;
const HEIGHT = 100;
/** As many as the paper shows. */
const MOST_CLUSTERS = 100;

/** Hits of the clusters, the most first (Fig 5, top). */
export function GraphStrip() {
  const list = current.value ? found.value.slice(0, MOST_CLUSTERS) : [];
  if (list.length === 0) {
    return (
      <div class={css["graph-strip"]}>
        <p class="hint">
          {running.value
            ? messages.countingVotesForEvery
            : series.value
              ? messages.findMapsTheirVotes
              : messages.dragPointsGraphChange}
        </p>
      </div>
    );
  }
  const most = Math.max(1, ...list.map(({ hits }) => hits));
  const step = WIDTH / Math.max(20, list.length);
  return (
    <div class={css["graph-strip"]}>
      <p class="hint">
        {messages.hitsUpTo(list.length)} <span class="number">{countWords(most)}</span>
      </p>
      <svg
        class={css["histogram"]}
        viewBox={`0 0 ${WIDTH} ${HEIGHT}`}
        preserveAspectRatio="none"
        role="img"
        aria-label={messages.hitsOf(list.length, most, list.at(-1)?.hits ?? 0)}
      >
        {list.map((cluster, index) => {
          const tall = Math.max(1.5, (HEIGHT * cluster.hits) / most);
          return (
            // biome-ignore lint/a11y/noStaticElementInteractions: the list of candidates does the same for keys
            <g
              key={index}
              class={`${css["bar"]} ${chosen.value === index ? css["chosen"] : ""}`}
              data-kind={cluster.kind}
              onClick={() => choose(index)}
            >
              <title>{messages.clusterHits(nameOf(cluster, index), countWords(cluster.hits))}</title>
              <rect class={css["reach"]} x={index * step} y={0} width={step} height={HEIGHT} />
              <rect
                class={css["spot"]}
                x={index * step + 0.1 * step}
                y={HEIGHT - tall}
                width={0.8 * step}
                height={tall}
              />
            </g>
          );
        })}
      </svg>
      <ul class={css["histogram-key"]}>
        <li>{messages.map}</li>
        <li data-kind="echo">{messages.echo}</li>
        <li data-kind="clutter">{messages.clutter}</li>
      </ul>
    </div>
  );
}

import { signal } from "@preact/signals";
import { Button } from "#ui/controls/Button";
import type { HoughCluster } from "#workers/fit/hough";
import { DomainFields } from "../DomainFields";
import graphCss from "../graph.module.css";
import * as messages from "../messages";
import { aboutOf, countWords, errorWords, mapWords, nameOf } from "../model/words";
import { choose, chosen, found, isPicked, mapOf, picks, search, setDomain, togglePick } from "./search";

/** As many are seen at first. */
const SEEN_AT_FIRST = 8;
const all = signal(false);

/** The clusters by hits, with their names, how well they hold, and whether they are picked. */
export function CandidateList() {
  const list = found.value;
  if (list.length === 0) return null;
  const shown = list
    .map((cluster, index) => ({ cluster, index }))
    .filter(({ index }) => all.value || index < SEEN_AT_FIRST || isPicked(index) || index === chosen.value);
  return (
    <div class="stack">
      <ul aria-label={messages.candidatesMostHitsFirst}>
        {shown.map(({ cluster, index }) => (
          <Row key={index} cluster={cluster} index={index} />
        ))}
      </ul>
      {list.length > SEEN_AT_FIRST && (
        <Button
          kind="quiet"
          onClick={() => {
            all.value = !all.peek();
          }}
        >
          {all.value ? messages.fewer : messages.allOf(list.length)}
        </Button>
      )}
    </div>
  );
}

function Row({ cluster, index }: { cluster: HoughCluster; index: number }) {
  const open = chosen.value === index;
  const name = nameOf(cluster, index);
  return (
    <li class={`${graphCss["candidate"]} ${open ? graphCss["open"] : ""}`}>
      <input
        type="checkbox"
        aria-label={messages.pick(name)}
        checked={isPicked(index)}
        onChange={() => togglePick(index)}
      />
      <button
        type="button"
        class={graphCss["candidate-name"]}
        aria-expanded={open}
        title={aboutOf(cluster)}
        onClick={() => choose(index)}
      >
        <span>{name}</span>
        <span class="dim number">{errorWords(cluster)}</span>
        <span class="dim number">{countWords(cluster.hits)}</span>
      </button>
      {open && (
        <div class={graphCss["candidate-more"]}>
          <p class="hint">{aboutOf(cluster)}</p>
          <p class="number">
            {mapWords(picks.value.find((one) => one.cluster === index)?.map ?? mapOf(cluster))}
          </p>
          {isPicked(index) && <Domain index={index} />}
        </div>
      )}
    </li>
  );
}

/** The part that a picked map copies. */
function Domain({ index }: { index: number }) {
  const pick = picks.value.find((one) => one.cluster === index);
  const fine = search.value?.sets.fine;
  if (!pick || !fine) return null;
  const [from, to] = [fine[0] ?? 0, fine[fine.length - 2] ?? 1];
  return (
    <DomainFields
      domain={pick.domain}
      within={[from, to]}
      onChange={(end, t) => {
        const domain: [number, number] = [...pick.domain];
        domain[end] = t;
        if (domain[0] >= domain[1]) return messages.partMustStartBefore;
        setDomain(index, domain);
        return undefined;
      }}
    />
  );
}

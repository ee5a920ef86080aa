import { useEffect, useRef, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { fixed, formatNumber } from "#format/numbers";
import { placeWords } from "#format/placement";
import { determinant3 } from "#geometry/maps/affine3";
import { Button } from "#ui/controls/Button";
import type { BoxCount3, MapRow3, Place3 } from "#wasm/api";
import { solid } from "#wasm/space";
import { spaceTask } from "#workers/space/client";
import * as messages from "./messages";
import { facts, moved, rested } from "./now";
import css from "./shape.module.css";

/** What is known of the object: its dimension, its maps, and what was done to it. */
export function FactsPanel() {
  const maps = rested.value;
  const now = facts.value;
  const by = moved.value;
  const times = determinant3(by);
  return (
    <dl class={css["solid-facts"]}>
      <Fact name="Maps">{maps.length}</Fact>
      {now && (
        <>
          <Fact name="Dimension">
            {now.similarity !== null
              ? formatNumber(now.similarity, 4)
              : messages.atMost(formatNumber(now.affinity, 4))}
            <small>
              {now.similarity !== null ? messages.exactIfPiecesDo : messages.affinityDimensionNotAll}
            </small>
          </Fact>
          <Boxes maps={maps} />
          <Fact name={messages.contractsBy}>
            {formatNumber(now.contractivity, 4)}
            <small>{messages.atLeastInSuitable}</small>
          </Fact>
          <Fact name={messages.centre}>({now.centre.map((x) => fixed(x, 3)).join(", ")})</Fact>
          <Fact name={messages.radius}>{formatNumber(now.radius, 4)}</Fact>
        </>
      )}
      <Fact name={messages.transformation}>
        {placeWords(placeOf(by))}
        <small>
          {times === 0
            ? messages.flat
            : messages.volumesTimes(
                formatNumber(Math.abs(times), 3),
                times < 0 ? messages.mirroredAside : "",
              )}
        </small>
      </Fact>
    </dl>
  );
}

function placeOf(by: MapRow3): Place3 | null {
  try {
    return solid.place3(by);
  } catch {
    return null;
  }
}

function Fact({ name, children }: { name: string; children: preact.ComponentChildren }) {
  return (
    <div>
      <dt>{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}

/** The dimension counted in boxes, when it is asked for. */
function Boxes({ maps }: { maps: MapRow3[] }) {
  const [counted, setCounted] = useState<{ of: MapRow3[]; result: BoxCount3 | string } | null>(null);
  const [busy, setBusy] = useState(false);
  const stop = useRef<AbortController | null>(null);
  useEffect(() => () => stop.current?.abort(), []);
  const count = async () => {
    stop.current?.abort();
    const now = new AbortController();
    stop.current = now;
    setBusy(true);
    try {
      const result = await spaceTask("boxes", { maps }, { signal: now.signal, lane: 2 });
      setCounted({ of: maps, result });
    } catch (problem) {
      if (!now.signal.aborted) setCounted({ of: maps, result: wordsOf(problem) });
    } finally {
      if (stop.current === now) setBusy(false);
    }
  };
  const result = counted?.of === maps ? counted.result : null;
  return (
    <Fact name={messages.inBoxes}>
      {result === null ? (
        <Button kind="quiet" disabled={busy} onClick={() => void count()}>
          {busy ? messages.counting : messages.count}
        </Button>
      ) : typeof result === "string" ? (
        result
      ) : (
        <>
          {formatNumber(result.dimension, 3)}
          <small>
            {messages.countedBoxes(
              result.counts.length,
              (result.counts.at(-1)?.[1] ?? 0).toLocaleString("en"),
            )}
          </small>
        </>
      )}
    </Fact>
  );
}

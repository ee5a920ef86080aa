import { useEffect, useRef, useState } from "preact/hooks";
import { wordsOf } from "#document/notice";
import { fixed, formatNumber } from "#format/numbers";
import { placeWords } from "#format/placement";
import { determinant3 } from "#geometry/maps/affine3";
import { Button } from "#ui/controls/Button";
import type { BoxCount3, MapRow3, Place3 } from "#wasm/api";
import { solid } from "#wasm/space";
import { spaceTask } from "#workers/space/client";
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
              : `at most ${formatNumber(now.affinity, 4)}`}
            <small>
              {now.similarity !== null
                ? "exactly, where its pieces do not overlap: all maps are similitudes"
                : "the affinity dimension: not all maps are similitudes"}
            </small>
          </Fact>
          <Boxes maps={maps} />
          <Fact name="Contracts by">
            {formatNumber(now.contractivity, 4)}
            <small>at least, in coordinates that suit it</small>
          </Fact>
          <Fact name="Middle">({now.centre.map((x) => fixed(x, 3)).join(", ")})</Fact>
          <Fact name="Radius">{formatNumber(now.radius, 4)}</Fact>
        </>
      )}
      <Fact name="What was done">
        {placeWords(placeOf(by))}
        <small>
          {times === 0
            ? "flat"
            : `volumes times ${formatNumber(Math.abs(times), 3)}${times < 0 ? ", mirrored" : ""}`}
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
    <Fact name="In boxes">
      {result === null ? (
        <Button kind="quiet" disabled={busy} onClick={() => void count()}>
          {busy ? "Counting…" : "Count"}
        </Button>
      ) : typeof result === "string" ? (
        result
      ) : (
        <>
          {formatNumber(result.dimension, 3)}
          <small>
            counted: {result.counts.length} sizes of boxes,{" "}
            {(result.counts.at(-1)?.[1] ?? 0).toLocaleString("en")} of the smallest
          </small>
        </>
      )}
    </Fact>
  );
}

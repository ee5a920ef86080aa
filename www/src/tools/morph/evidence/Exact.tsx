/** What follows from the exact numbers of a shape: its neighbours, and what they tell. */
import { useEffect, useState } from "preact/hooks";
import { analyzeShown, endShown } from "#compute/exact";
import { verdict } from "#compute/results";
import { withDirected } from "#document/directed/changes";
import { readExact } from "#document/editing/exact";
import { selection, shown } from "#document/morph";
import { announce, notify, wordsOf } from "#document/notice";
import { edit, scene, undo } from "#document/scene";
import { exactOf } from "#geometry/maps/exact";
import { Button } from "#ui/controls/Button";
import type { Analysis, Dimension, DirectedMap, MapRow, Reason } from "#wasm/api";
import { shownExact } from "../maps/exact-fields";
import { setMaps } from "../maps/map-edits";
import css from "./evidence.module.css";
import * as messages from "./messages";

export function Exact({ reason }: { reason: Reason | undefined }) {
  const assuming = reason?.assuming ?? [];
  const numbers = verdict.value?.numbers ?? [];
  shown.value;
  return (
    <>
      {assuming.length > 0 && endShown() !== null && (
        <Button onClick={() => void takeExact(assuming)}>{messages.useExact}</Button>
      )}
      {numbers.length > 0 && (
        <p>
          <span class={css["evidence-name"]}>{messages.exactNumbers}</span> {list(numbers)}.
        </p>
      )}
      <Neighbours />
    </>
  );
}

const list = (formulas: readonly string[]) => formulas.map((one) => shownExact(one)).join(", ");

/** The maps of the end that is shown mean what the reason has read: "0.3333333333333333 is 1/3". */
async function takeExact(assuming: readonly string[]): Promise<void> {
  const end = endShown();
  if (end === null) return;
  const readings = assuming.map((one) => one.split(" is ") as [double: string, formula: string]);
  try {
    const found = await readExact(
      readings.map(([, formula]) => formula.replace(/\s/g, "").replace(/°/g, "deg")),
    );
    const exactly = new Map<number, number>();
    for (const [k, [double]] of readings.entries()) {
      const one = found[k];
      if (one) exactly.set(Number(double), Math.abs(one.value));
    }
    const formulas = found.flatMap((one) => one?.formula ?? []);
    if (formulas.length < readings.length) {
      notify({ kind: "info", text: messages.notAllExact });
      return;
    }
    edit((before) => {
      const next = before[end].maps.map(
        (map) => map.map((x) => Math.sign(x) * (exactly.get(Math.abs(x)) ?? Math.abs(x))) as MapRow,
      );
      return setMaps(before, end, next, formulas);
    });
    announce(messages.exactUsed(list(exactOf(scene.peek()[end]))));
  } catch (problem) {
    notify({ kind: "error", text: wordsOf(problem) });
  }
}

type Found =
  | { state: "asked" }
  | { state: "there"; analysis: Analysis | null }
  | { state: "failed"; why: string };

function Neighbours() {
  const [open, setOpen] = useState(false);
  const [found, setFound] = useState<Found | null>(null);
  const maps = shown.value;
  // biome-ignore lint/correctness/useExhaustiveDependencies: other maps are asked about anew
  useEffect(() => {
    if (!open) return;
    let current = true;
    const set = (next: Found) => current && setFound(next);
    set({ state: "asked" });
    analyzeShown().then(
      (analysis) => set({ state: "there", analysis }),
      (problem) => set({ state: "failed", why: whyNot(problem) }),
    );
    return () => {
      current = false;
    };
  }, [open, maps]);
  return (
    <details
      class={css["evidence-analysis"]}
      open={open}
      onToggle={(event) => setOpen(event.currentTarget.open)}
      data-testid="analysis"
    >
      <summary>{messages.analysis}</summary>
      <p role="status">{found?.state === "asked" && messages.analyzing}</p>
      {found && <Answer found={found} />}
    </details>
  );
}

/** Some shapes have no such graph: that is no failure. */
function whyNot(problem: unknown): string {
  const code = (problem as { code?: unknown } | null)?.code;
  if (code === "exact-singular") return messages.flatMap;
  return messages.analysisFailed(wordsOf(problem));
}

function Answer({ found }: { found: Found }) {
  if (found.state === "failed") return <p>{found.why}</p>;
  if (found.state === "asked") return null;
  if (!found.analysis) return <p>{messages.onlyAtEnds}</p>;
  const rows = rowsOf(found.analysis);
  if (rows.length === 0) return <p>{messages.nothingFound}</p>;
  const states = found.analysis.boundary?.states;
  return (
    <>
      <dl>
        {rows.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      {states && (
        <Button description={messages.boundaryReplaces} onClick={() => openBoundary(states)}>
          {messages.openBoundary}
        </Button>
      )}
    </>
  );
}

/** The boundary in the place of the shape, as a graph-directed shape: one step to undo. */
function openBoundary(states: DirectedMap[][]): void {
  const end = endShown();
  if (end === null) return;
  const name = messages.boundaryOf(scene.peek()[end].name);
  selection.value = null;
  edit((before) => {
    const { tool: _, view: __, ...rest } = withDirected(before, end, { name, states });
    return { ...rest, t: end === "b" ? 1 : 0 };
  });
  notify({
    kind: "info",
    text: messages.boundaryOpened(name),
    action: { label: messages.undo, run: undo },
  });
}

const CONDITION = {
  yes: messages.holdsProved,
  no: messages.doesNotHold,
  undecided: messages.notDecidedYet,
} as const;

function rowsOf({
  openSetCondition,
  neighbours,
  dimension,
  boundary,
  innerPoints,
}: Analysis): [string, string][] {
  const rows: [string, string][] = [];
  // That it is no more than the plane says nothing.
  const bound = dimension && (dimension.proved || dimension.upper < 2) ? dimension : null;
  if (!bound && neighbours === null && openSetCondition === "undecided") return rows;
  rows.push([messages.openSetCondition, CONDITION[openSetCondition]]);
  if (neighbours !== null) rows.push([messages.neighbours, String(neighbours)]);
  if (bound) rows.push([messages.dimension, dimensionWords(bound)]);
  if (innerPoints !== null) rows.push([messages.innerPoints, innerPoints ? messages.yes : messages.no]);
  if (boundary) rows.push([messages.dimensionOfBoundary, dimensionWords(boundary.dimension)]);
  return rows;
}

/** Digits of a dimension that are shown. */
const DIGITS = 6;

function dimensionWords({ value, upper, proved, exact }: Dimension): string {
  // No bound is shown below what it is.
  if (!proved) return messages.atMostOf((Math.ceil(upper * 10 ** DIGITS) / 10 ** DIGITS).toFixed(DIGITS));
  if (exact !== null && /^\d+$/.test(exact)) return messages.proved(exact);
  const words = value.toFixed(DIGITS);
  return exact === null ? messages.proved(words) : messages.equals(exact, words);
}

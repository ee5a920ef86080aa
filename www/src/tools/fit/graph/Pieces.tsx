import { endGesture } from "#document/scene";
import { formatNumber } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { Slider } from "#ui/controls/Slider";
import { Switch } from "#ui/controls/Switch";
import { CopiedSpan, colourOf, IndexSelect, PieceList, PieceNumber } from "../by-hand/PieceList";
import css from "./graph.module.css";
import * as messages from "./messages";
import {
  asPlaneCurve,
  changeModel,
  chooseKind,
  chosenKnot,
  chosenPiece,
  FIRST,
  facts,
  isFirst,
  model,
  problem,
  take,
  value,
} from "./model/document";
import { KINDS } from "./model/graph-text";
import {
  interval,
  type Kind,
  MOST_C,
  MOST_PIECES,
  spanOf,
  withKnot,
  withKnotIn,
  withoutKnot,
  withPart,
} from "./model/model";

/** What the graph is made of. */
export function FunctionSection() {
  const now = model.value;
  return (
    <section class="stack">
      <div class="section-head">
        <h2>{messages.functionLabel}</h2>
        <Button kind="quiet" icon="reset" disabled={isFirst.value} onClick={() => take(FIRST)}>
          {messages.figure1}
        </Button>
      </div>
      <p class="row-name">{messages.everyPieceSmallerCopy}</p>
      <Segmented<Kind>
        label={messages.whatEveryPieceCopies}
        options={KINDS.map(({ value: kind, label, about }) => ({ value: kind, label, description: about }))}
        value={now.kind}
        onChange={chooseKind}
      />
      <p class="hint">{KINDS.find((one) => one.value === now.kind)?.about}</p>
      <PieceList
        id="graph-piece"
        count={now.parts.length}
        chosen={chosenPiece.value}
        onChoose={choosePiece}
        row={(index, open) => <PieceRow key={index} index={index} open={open} />}
      />
      <KnotFields />
      <Button kind="quiet" icon="arrow" description={messages.sameGraphAsCurve} onClick={asPlaneCurve}>
        {messages.asCurvePlane}
      </Button>
      <FactList />
    </section>
  );
}

const choosePiece = (piece: number) => {
  chosenPiece.value = piece;
};

function PieceRow({ index, open }: { index: number; open: boolean }) {
  const { parts, kind } = model.value;
  const part = parts[index];
  if (!part) return null;
  const change = (c: number) =>
    changeModel((now) => withPart(now, index, { c }), `roughness ${index}`)
      ? undefined
      : (problem.peek() ?? "");
  const words = `${formatNumber(part.c, 2)}, ${roughWords(part.c)}`;
  return (
    <li
      class={open ? `${css["graph-piece"]} ${css["open"]}` : css["graph-piece"]}
      style={{ "--piece": colourOf(index) }}
    >
      <PieceNumber piece={index} open={open} onChoose={choosePiece} />
      <Slider
        label={messages.roughnessOf(index + 1)}
        value={part.c}
        min={-0.95}
        max={0.95}
        valueText={words}
        onChange={(c) => change(Number(c.toFixed(3)))}
        onDone={endGesture}
      />
      <NumberField
        label={messages.roughnessOf(index + 1)}
        symbol="c"
        terse
        value={part.c}
        min={-MOST_C}
        max={MOST_C}
        digits={3}
        onChange={change}
        onDone={endGesture}
      />
      {open && (
        <div class={css["piece-more"]}>
          <Switch
            checked={part.reflected}
            onChange={(reflected) => changeModel((now) => withPart(now, index, { reflected }))}
            description={messages.copyRunsFromRight}
          >
            {messages.mirrored}
          </Switch>
          {kind !== "fif" && <Domain index={index} />}
          <Button
            kind="quiet"
            icon="add"
            disabled={parts.length >= MOST_PIECES}
            description={messages.addsPointInMiddle}
            onClick={() => addKnot(index)}
          >
            {messages.point}
          </Button>
        </div>
      )}
    </li>
  );
}

function roughWords(c: number): string {
  const size = Math.abs(c);
  if (size === 0) return "straight";
  return size < 0.3 ? "calm" : size < 0.6 ? "rough" : messages.veryRough;
}

function addKnot(piece: number): void {
  const at = value.peek();
  if (changeModel((now) => withKnotIn(now, piece, at))) chosenKnot.value = piece + 1;
}

/** What a piece copies: from knot to knot, or from any t to any other. */
function Domain({ index }: { index: number }) {
  const { parts, knots, kind } = model.value;
  const part = parts[index];
  if (!part) return null;
  if (kind === "rfif") {
    const span = spanOf(knots, part.domain);
    const set = (end: 0 | 1, knot: number) =>
      changeModel((now) => {
        const to: [number, number] = [...(now.parts[index]?.domain ?? [0, 1])];
        to[end] = now.knots[knot]?.[0] ?? to[end];
        return withPart(now, index, { domain: [Math.min(...to), Math.max(...to)] });
      });
    return <CopiedSpan piece={index} span={span} count={knots.length} onChange={set} />;
  }
  const [from, to] = interval(knots);
  const set = (end: 0 | 1, t: number) => {
    const done = changeModel((now) => {
      const domain: [number, number] = [...(now.parts[index]?.domain ?? [0, 1])];
      domain[end] = t;
      return withPart(now, index, { domain });
    }, `domain ${index} ${end}`);
    return done ? undefined : (problem.peek() ?? "");
  };
  return <DomainFields domain={part.domain} within={[from, to]} onChange={set} onDone={endGesture} />;
}

/** The chosen point in numbers. */
function KnotFields() {
  const { knots } = model.value;
  const index = chosenKnot.value ?? 0;
  const knot = knots[index];
  if (!knot) return null;
  const [from, to] = interval(knots);
  const set = (at: 0 | 1, x: number) => {
    const done = changeModel((now) => {
      const old = now.knots[index] ?? [0, 0];
      return withKnot(now, index, at === 0 ? [x, old[1]] : [old[0], x]);
    }, `knot ${index} ${at}`);
    return done ? undefined : (problem.peek() ?? "");
  };
  return (
    <fieldset class={css["knot-fields"]}>
      <legend class="row-name">
        {messages.point}{" "}
        <IndexSelect
          label={messages.point2}
          value={index}
          count={knots.length}
          onChange={(knot) => {
            chosenKnot.value = knot;
          }}
        />
      </legend>
      <NumberField
        label={messages.placeOf(index + 1)}
        symbol="t"
        terse
        value={knot[0]}
        step={0.01 * (to - from)}
        onChange={(t) => set(0, t)}
        onDone={endGesture}
      />
      <NumberField
        label={messages.heightOf(index + 1)}
        symbol="x"
        terse
        value={knot[1]}
        onChange={(x) => set(1, x)}
        onDone={endGesture}
      />
      <Button
        kind="quiet"
        icon="bin"
        disabled={index === 0 || index === knots.length - 1}
        onClick={() => changeModel((now) => withoutKnot(now, index))}
      >
        {messages.remove}
      </Button>
    </fieldset>
  );
}

function FactList() {
  const now = facts.value;
  if (!now) return null;
  const rows: [string, string, string][] = [
    [
      messages.boxDimension,
      now.dimension === null ? "–" : `${now.counted ? "about " : ""}${formatNumber(now.dimension, 4)}`,
      now.counted ? messages.byCountingBoxes : messages.fromEquationFactors,
    ],
    [messages.contractivity, formatNumber(now.contractivity, 4), messages.howMuchEachStep],
    [
      messages.integral,
      now.integral === null ? "–" : formatNumber(now.integral, 5),
      now.integral === null ? messages.exactOnlyWhereParts : "exact",
    ],
    [
      messages.widestGap,
      now.continuous ? "none" : formatNumber(now.widestGap, 5),
      messages.betweenNeighbouringPieces,
    ],
  ];
  return (
    <dl class={css["graph-facts"]}>
      {rows.map(([name, words, about]) => (
        <div key={name} title={about}>
          <dt>{name}</dt>
          <dd class="number">{words}</dd>
        </div>
      ))}
    </dl>
  );
}

interface DomainFieldsProps {
  domain: readonly [from: number, to: number];
  /** Where all of the graph lies. */
  within: readonly [from: number, to: number];
  /** Takes one end, or says why it cannot be. */
  onChange: (end: 0 | 1, t: number) => string | undefined;
  onDone?: () => void;
}

/** The part of a graph that a piece copies. */
export function DomainFields({ domain, within: [from, to], onChange, onDone = () => {} }: DomainFieldsProps) {
  return (
    <div class={css["piece-domain"]}>
      {([0, 1] as const).map((end) => (
        <NumberField
          key={end}
          label={end === 0 ? messages.copiesFrom : messages.to}
          symbol={end === 0 ? "α" : "β"}
          value={domain[end]}
          min={from}
          max={to}
          step={0.01 * (to - from)}
          onChange={(t) => onChange(end, t)}
          onDone={onDone}
        />
      ))}
    </div>
  );
}

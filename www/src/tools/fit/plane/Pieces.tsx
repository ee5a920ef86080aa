import { computed, signal } from "@preact/signals";
import { endGesture } from "#document/scene";
import { fixed } from "#format/numbers";
import { Button } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import { Switch } from "#ui/controls/Switch";
import { CopiedSpan, colourOf, PieceList, PieceNumber } from "../by-hand/PieceList";
import graphCss from "../graph/graph.module.css";
import * as messages from "../messages";
import { FactorPad } from "./FactorPad";
import {
  alongSide,
  apart,
  type Factor,
  isApart,
  MOST_ENTRY,
  MOST_PIECES,
  norm,
  sideOf,
  withPiece,
  withPointIn,
} from "./model/curve";
import { change, chosenPiece, chosenPoint, curve, placeAt, problem, setFactor } from "./model/document";
import css from "./plane.module.css";

const ENTRIES = [
  { k: 0, name: "x from x", symbol: "cx", own: true },
  { k: 1, name: "x from y", symbol: "cxy", own: false },
  { k: 2, name: "y from x", symbol: "cyx", own: false },
  { k: 3, name: "y from y", symbol: "cy", own: true },
] as const;

/** Both are asked for, though no factor needs it yet. */
const together = signal(false);
const shownApart = computed(() => isApart(curve.value) && !together.value);
const choosePiece = (piece: number) => {
  chosenPiece.value = piece;
};

/** What copies may do, and each piece. */
export function Pieces() {
  return (
    <>
      <p class="row-name">{messages.inCopyXAnd}</p>
      <Segmented
        label={messages.howXAndY}
        options={[
          {
            value: "apart",
            label: messages.onThemselvesOnly,
            description: messages.eq8XAnd,
          },
          { value: "together", label: messages.onBoth, description: messages.eq9CopiesRotate },
        ]}
        value={shownApart.value ? "apart" : "together"}
        onChange={(kind) => {
          together.value = kind === "together";
          if (kind === "apart") change(apart);
        }}
      />
      <PieceList
        id="plane-piece"
        count={curve.value.pieces.length}
        chosen={chosenPiece.value}
        onChoose={choosePiece}
        row={(index, open) => <Row key={index} index={index} open={open} />}
      />
    </>
  );
}

/** What a factor does, in words. */
function about(factor: Factor, side: "turned" | "mirrored" | null): string {
  const size = messages.times(fixed(norm(factor), 2));
  if (factor.every((x) => x === 0)) return "straight";
  if (side === null) return messages.atMostLarge(size);
  const degrees = Math.round((180 / Math.PI) * Math.atan2(factor[2], factor[0]));
  if (side === "mirrored") return messages.mirroredLarge(size);
  return degrees === 0 ? messages.large(size) : messages.rotatedLarge(size, degrees);
}

function Row({ index, open }: { index: number; open: boolean }) {
  const now = curve.value;
  const piece = now.pieces[index];
  if (!piece) return null;
  return (
    <li class={css["plane-row"]} style={{ "--piece": colourOf(index) }}>
      <PieceNumber piece={index} open={open} onChoose={choosePiece} />
      <span class={`${css["plane-about"]} number`}>{about(piece.factor, sideOf(now, index))}</span>
      {open && <More index={index} factor={piece.factor} />}
    </li>
  );
}

function More({ index, factor }: { index: number; factor: Factor }) {
  const now = curve.value;
  const side = sideOf(now, index);
  const set = (k: number, value: number) => {
    const next: Factor = [...factor];
    next[k] = value;
    return setFactor(index, next, `entry ${index} ${k}`) ? undefined : (problem.peek() ?? "");
  };
  const along = (mirrored: boolean) => {
    const next = alongSide(now, index, mirrored);
    if (next) setFactor(index, next, `side ${index}`);
    endGesture();
  };
  return (
    <div class={css["plane-more"]}>
      <FactorPad piece={index} factor={factor} apart={shownApart.value} />
      <div class={css["entries"]}>
        {ENTRIES.filter(({ own }) => own || !shownApart.value).map(({ k, name, symbol }) => (
          <NumberField
            key={k}
            label={messages.entryOf(name, index + 1)}
            symbol={symbol}
            terse
            value={factor[k]}
            min={-MOST_ENTRY}
            max={MOST_ENTRY}
            digits={3}
            onChange={(value) => set(k, value)}
            onDone={endGesture}
          />
        ))}
      </div>
      {!shownApart.value && (
        <div class="row">
          <Button
            pressed={side === "turned"}
            description={messages.copySimilarToWhat}
            onClick={() => along(false)}
          >
            {messages.alongSide}
          </Button>
          <Button
            pressed={side === "mirrored"}
            description={messages.sameMirroredAtSide}
            onClick={() => along(true)}
          >
            {messages.mirrored}
          </Button>
        </div>
      )}
      <Span index={index} />
      <div class={graphCss["piece-more"]}>
        <Switch
          checked={isBack(index)}
          onChange={() =>
            change((old) => {
              const [from, to] = old.pieces[index]?.span ?? [0, 1];
              return withPiece(old, index, { span: [to, from] });
            })
          }
          description={messages.copyStartsWhereLast}
        >
          {messages.runsBackwards}
        </Switch>
        <Button
          kind="quiet"
          icon="add"
          disabled={now.pieces.length >= MOST_PIECES}
          description={messages.addsPointInMiddleThis}
          onClick={() => addPoint(index)}
        >
          {messages.point}
        </Button>
      </div>
    </div>
  );
}

const isBack = (index: number): boolean => {
  const [from, to] = curve.value.pieces[index]?.span ?? [0, 1];
  return from > to;
};

/** What a piece copies: from point to point. */
function Span({ index }: { index: number }) {
  const { pieces, points } = curve.value;
  const span = pieces[index]?.span ?? [0, 1];
  const [low, high] = [Math.min(...span), Math.max(...span)];
  const set = (end: 0 | 1, to: number) => {
    const ends = end === 0 ? [to, high] : [low, to];
    const next: [number, number] = [Math.min(...ends), Math.max(...ends)];
    change((now) => withPiece(now, index, { span: isBack(index) ? [next[1], next[0]] : next }));
  };
  return <CopiedSpan piece={index} span={[low, high]} count={points.length} onChange={set} />;
}

function addPoint(piece: number): void {
  const { points } = curve.peek();
  const [from, to] = [points[piece]?.[0] ?? 0, points[piece + 1]?.[0] ?? 1];
  const place = placeAt((from + to) / 2);
  if (place && change((now) => withPointIn(now, piece, place))) chosenPoint.value = piece + 1;
}

import { bytesOf, changeFit, fitDocument, withBytes } from "#document/fit";
import { endGesture } from "#document/scene";
import { NumberField } from "#ui/controls/NumberField";
import { Segmented } from "#ui/controls/Segmented";
import type { ByteRival } from "#workers/fit/curve";
import fitCss from "../fit.module.css";
import { BYTE_METHODS, compareBytes } from "../fit-text";
import { LEAST_BYTES, MOST_BYTES } from "../numbers";
import { awaited } from "../work/progress";
import { source } from "../work/source";
import { byteRivals, shownWithin, type WithinDone, withinDone } from "../work/within";
import { Bars, Fact, Table } from "./facts";
import * as messages from "./messages";

const USUAL = [50, 150, 500] as const;

/** How many bytes there are. */
export function Within() {
  const bytes = bytesOf(fitDocument.value);
  const change = (next: number) => changeFit((now) => withBytes(now, next), { gesture: "bytes" });
  return (
    <div class="stack">
      <div class="row">
        <span class="row-name" aria-hidden="true">
          {messages.bytes2}
        </span>
        <span class={fitCss["bytes"]}>
          <Segmented
            label={messages.bytes2}
            value={String(bytes)}
            options={USUAL.map((few) => ({ value: String(few), label: String(few) }))}
            onChange={(next) => {
              change(Number(next));
              endGesture();
            }}
          />
          <NumberField
            label={messages.anyNumberBytes}
            value={bytes}
            min={LEAST_BYTES}
            max={MOST_BYTES}
            whole
            terse
            onChange={(next) => change(Math.round(next))}
            onDone={endGesture}
          />
        </span>
      </div>
      <p class="hint">{messages.curveCornersAndParabolas}</p>
    </div>
  );
}

/** How near it is, what it takes, and how near others come with as many bytes. */
export function WithinFigures() {
  const fit = shownWithin.value;
  const done = withinDone.value;
  const current = done && fit && done.word === fit.word ? done : null;
  if (!fit) return awaited.value ? <p class="hint">{messages.firstFitWillAppear}</p> : null;
  return (
    <>
      {current?.figures ? (
        <Table figures={current.figures} />
      ) : current && source.value.kind === "kept" ? (
        <p class="hint">{messages.thisFitHasNoOutline}</p>
      ) : null}
      {current && (
        <dl class={`${fitCss["facts"]} number`} data-testid="within-facts">
          <Fact name={messages.allBytes}>{current.bytes.toLocaleString("en-GB")}</Fact>
          <Fact name={messages.charactersInLink}>{current.word.length.toLocaleString("en-GB")}</Fact>
          <Fact name={messages.corners}>{current.corners}</Fact>
          <Fact name="Parabolas">{current.bends}</Fact>
        </dl>
      )}
      {current?.figures && <Others own={current} rms={current.figures.rms} all={byteRivals.value} />}
    </>
  );
}

function Others({ own, rms, all }: { own: WithinDone; rms: number; all: readonly ByteRival[] | null }) {
  if (!all) return <p class="hint">{messages.fittingOtherMethodsWithSame}</p>;
  return (
    <>
      <Bars
        caption={messages.othersWithBytes(own.asked.toLocaleString("en-GB"))}
        rows={[
          { name: messages.cornersAndParabolasFrond, about: messages.thisFit, rms, own: true },
          ...all.map(({ method, rms }) => ({ ...BYTE_METHODS[method], rms, own: false })),
        ]}
        words={compareBytes(rms, all)}
      />
      <p class="hint">{messages.polylinesPackedInSame}</p>
    </>
  );
}

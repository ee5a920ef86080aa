import { announce } from "#document/notice";
import { Button } from "#ui/controls/Button";
import { Segmented } from "#ui/controls/Segmented";
import { SliderField } from "#ui/controls/SliderField";
import { SliderMark } from "#ui/controls/SliderMarks";
import { Switch } from "#ui/controls/Switch";
import { ChoiceRow } from "#ui/panel/ChoiceRow";
import type { Component, TraceWarning } from "#workers/fit/trace-types";
import fitCss from "../fit.module.css";
import { brushSize, exact, type Hand, hand } from "../stage/brush";
import { step } from "../stage/layers";
import {
  addStroke,
  canRedoStroke,
  canUndoStroke,
  changeMask,
  leftOut,
  masked,
  masking,
  outlined,
  part,
  redoStroke,
  settings,
  traced,
  undoStroke,
  warnings,
} from "../work/mask";
import { former, opened, takeFormer } from "../work/source";
import { type Quarters, turnPicture } from "../work/turn";
import * as messages from "./messages";

/** Between a picture and its outline: the mask and what mends it. */
export function CutPanel() {
  if (!opened.value) return null;
  return (
    <section class={`${fitCss["cut-panel"]} stack`} aria-label={messages.cutOut}>
      <Segmented
        label={messages.step}
        value={step.value}
        options={[
          { value: "cut", label: messages.n1CutOut, description: messages.markLeafInPicture },
          {
            value: "fit",
            label: messages.n2Fit,
            description: messages.findFormulaOutline,
            disabled: step.value === "cut" && !outlined.value,
          },
        ]}
        onChange={(next) => {
          step.value = next;
          if (next === "fit") hand.value = "move";
        }}
      />
      {step.value === "cut" && <Mask />}
    </section>
  );
}

function Mask() {
  const { threshold, stalk } = settings.value;
  return (
    <>
      <Button
        kind="primary"
        icon="arrow"
        disabled={!outlined.value}
        description={masking.value ? messages.waitForNewOutline : messages.findFormulaThisOutline}
        onClick={() => {
          step.value = "fit";
          hand.value = "move";
        }}
      >
        {masking.value ? messages.findingOutline : messages.fitThisOutline}
      </Button>
      <Messages />
      <LeftOut />
      <Brush />
      <Parts />
      <Turn />
      <SliderField
        digits={2}
        label={messages.threshold}
        value={threshold}
        min={-1}
        max={1}
        step={0.05}
        words={thresholdWords(threshold)}
        ends={["less", "more"]}
        onChange={(next) => changeMask((now) => ({ ...now, threshold: next }))}
      >
        <SliderMark at={0.5} title={messages.automaticThreshold} />
      </SliderField>
      <Switch
        checked={stalk === "remove"}
        description={messages.removesThinPartsStick}
        onChange={(off) => changeMask((now) => ({ ...now, stalk: off ? "remove" : "keep" }))}
      >
        {messages.removeStalk}
      </Switch>
    </>
  );
}

function thresholdWords(x: number): string {
  if (x === 0) return messages.automatic;
  return messages.thresholdBy(Math.abs(x).toFixed(2), x < 0 ? "less" : "more");
}

/** What may be amiss, and the way back. */
function Messages() {
  const list = warnings.value;
  const back = former.value;
  const lost = masked.value !== null && !traced.value;
  const bringBack = bringBackWords(list, exact.value);
  return (
    <div class={fitCss["cut-messages"]} role="status">
      {list.length > 0 && (
        <ul class="notes">
          {list.map(({ code, message }) => (
            <li key={code}>{message}</li>
          ))}
        </ul>
      )}
      {bringBack !== null && <p class="notes">{bringBack}</p>}
      {lost && list.length === 0 && <p class="notes">{messages.nothingWasFoundDraw}</p>}
      {lost && back && (
        <Button kind="quiet" icon="back" onClick={takeFormer}>
          {messages.backTo(back.name)}
        </Button>
      )}
    </div>
  );
}

/** A part beside the outline, which may belong to the leaf. */
function LeftOut() {
  const near = leftOut.value;
  if (!near) return null;
  return (
    <div class={fitCss["cut-messages"]} role="status">
      <p class="notes">{messages.partClose(near.index + 1, percentOf(near.share))}</p>
      <Button
        icon="add"
        description={messages.fillsGapBetweenTwo}
        onClick={() => {
          addStroke(near.stroke);
          announce(messages.partJoined(near.index + 1));
        }}
      >
        {messages.joinPart(near.index + 1)}
      </Button>
    </div>
  );
}

const percentOf = (share: number) => `${Math.max(1, Math.round(100 * share))}%`;

const TURNS: readonly { quarters: Quarters; label: string; description: string }[] = [
  { quarters: 3, label: messages.left, description: messages.rotatePhotoQuarterTurn },
  { quarters: 1, label: messages.right, description: messages.rotatePhotoQuarterTurnTo },
  { quarters: 2, label: messages.upsideDown, description: messages.rotatePhotoByHalf },
];

/** A leaf that was scanned with its tip down. */
function Turn() {
  return (
    <fieldset class={fitCss["turns"]}>
      <legend class="row-name">{messages.rotate}</legend>
      {TURNS.map(({ quarters, label, description }) => (
        <Button key={quarters} description={description} onClick={() => void turnPicture(quarters)}>
          {label}
        </Button>
      ))}
    </fieldset>
  );
}

const HANDS: readonly { value: Hand; label: string; description: string }[] = [
  { value: "move", label: messages.move, description: messages.dragToMovePicture },
  { value: "keep", label: messages.leaf, description: messages.paintOverLeaf },
  { value: "remove", label: messages.notLeaf, description: messages.paintOverWhatNot },
];

function Brush() {
  return (
    <div class="stack">
      <ChoiceRow
        label={messages.brush}
        name={messages.dragMode}
        value={hand.value}
        options={HANDS}
        onChange={(next) => {
          hand.value = next;
        }}
      />
      {hand.value === "move" && masked.value && <p class="hint">{messages.tooLittleOrToo}</p>}
      {hand.value !== "move" && (
        <>
          <SliderField
            label={messages.brushSize}
            value={brushSize.value}
            min={0.2}
            max={20}
            step={0.2}
            digits={1}
            unit="%"
            words={messages.brushPercent(brushSize.value)}
            onChange={(next) => {
              brushSize.value = next;
            }}
          />
          <Switch
            checked={exact.value}
            description={messages.onStrokeChangesOnly}
            onChange={(on) => {
              exact.value = on;
            }}
          >
            {messages.doNotSpread}
          </Switch>
          <p class="hint">
            {messages.brushKeys(
              exact.value ? messages.onlyPaintedPixelsChange : messages.oneStrokeOftenEnough,
            )}
          </p>
        </>
      )}
      <div class={fitCss["source-buttons"]}>
        <Button kind="quiet" icon="reset" disabled={!canUndoStroke()} onClick={undoStroke}>
          {messages.undoStroke}
        </Button>
        {canRedoStroke() && (
          <Button kind="quiet" onClick={redoStroke}>
            {messages.redoStroke}
          </Button>
        )}
      </div>
    </div>
  );
}

const MOST_PARTS = 12;

/** What the mask falls into, the largest first. */
function Parts() {
  const mask = masked.value;
  if (!mask || mask.components.length < 2) return null;
  const all = mask.components.slice(0, MOST_PARTS);
  return (
    <fieldset class={fitCss["parts"]}>
      <legend class="row-name">{messages.part}</legend>
      {all.map((component, i) => (
        <label key={i} class={fitCss["cut-part"]} title={messages.partNumber(i + 1)}>
          <input
            class="covering"
            type="radio"
            name="fit-part"
            checked={part.value === i}
            onChange={() => {
              part.value = i;
            }}
          />
          <PartDrawing component={component} width={mask.width} height={mask.height} mask={mask.mask} />
          <span>
            {i + 1}
            <span class="unseen">
              {messages.partPercent(
                Math.max(1, Math.round((100 * component.area) / (mask.width * mask.height))),
              )}
            </span>
          </span>
        </label>
      ))}
    </fieldset>
  );
}

const SIDE = 36;

function PartDrawing({
  component,
  width,
  mask,
}: {
  component: Component;
  width: number;
  height: number;
  mask: Uint8Array;
}) {
  const [x0, y0, x1, y1] = component.box;
  const scale = SIDE / Math.max(x1 - x0, y1 - y0, 1);
  const draw = (canvas: HTMLCanvasElement | null) => {
    const context = canvas?.getContext("2d");
    if (!canvas || !context) return;
    context.clearRect(0, 0, SIDE, SIDE);
    context.fillStyle = getComputedStyle(canvas).color;
    for (let y = 0; y < SIDE; y++) {
      for (let x = 0; x < SIDE; x++) {
        const px = Math.floor(x0 + (x + 0.5) / scale);
        const py = Math.floor(y0 + (y + 0.5) / scale);
        if (px < x1 && py < y1 && mask[py * width + px]) context.fillRect(x, y, 1, 1);
      }
    }
  };
  return <canvas ref={draw} class={fitCss["part-drawing"]} width={SIDE} height={SIDE} />;
}

/**
 * What has to be done first where a stroke is to bring back what surrounds the picture, as the warning itself tells: a
 * stroke of exactly what is painted brings back no more than that.
 */
export function bringBackWords(warnings: readonly TraceWarning[], exact: boolean): string | null {
  if (!exact || !warnings.some(({ code }) => code === "surrounded")) return null;
  return messages.turnOffDoNot;
}

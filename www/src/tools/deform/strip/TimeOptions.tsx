import { changeDeformation, deformation, movesAt } from "#document/deform/bend";
import { keyNear, MOST_KEYS, momentOf, SAME } from "#document/deform/keys";
import { announce } from "#document/notice";
import { endGesture } from "#document/scene";
import { Button, IconButton } from "#ui/controls/Button";
import { NumberField } from "#ui/controls/NumberField";
import { PercentField } from "#ui/strip/PercentField";
import { pausePhase, scrubPhase } from "../clock";
import { withKey, withKeyAt, withLoop, withoutKey } from "../deform-edits";
import { percentWords } from "../deform-text";
import * as messages from "../messages";
import css from "./strip.module.css";

/** The numbers of the time line, and what can be done with its keys. */
export function TimeOptions() {
  const { phase, seconds, loop } = deformation.value;
  return (
    <div class={css["time-options"]}>
      <PercentField label={messages.timeInPercent} value={phase} onChange={scrubPhase} />
      <NumberField
        terse
        label={messages.durationInSeconds}
        value={seconds}
        min={0.5}
        max={60}
        step={0.5}
        digits={2}
        unit="s"
        onChange={(next) => changeDeformation((d) => ({ ...d, seconds: next }), { gesture: "seconds" })}
        onDone={endGesture}
      />
      <IconButton
        icon="loop"
        label={messages.loop}
        kind="quiet"
        pressed={loop}
        onClick={() => changeDeformation((d) => withLoop(d, !d.loop))}
      />
      <KeyOptions />
    </div>
  );
}

/** Of the key at the present moment; where there is none, one can be made. */
function KeyOptions() {
  const { keys, phase } = deformation.value;
  const alone = keys.length === 1;
  const near = keyNear(deformation.value, phase);
  const key = keys[near];
  // One key alone is the mesh at all times, but it stands at one of them.
  const away = alone && key !== undefined && Math.abs(key.at - momentOf(deformation.value, phase)) > SAME;
  if (key === undefined || away)
    return (
      <Button
        class={css["key-add"]}
        icon="add"
        disabled={keys.length >= MOST_KEYS}
        description={keys.length >= MOST_KEYS ? messages.keysFull(MOST_KEYS) : messages.keepGridThisMoment}
        command="key"
        onClick={addKey}
      >
        {messages.addKeyframe2}
      </Button>
    );
  return (
    <div class={css["key-options"]}>
      <NumberField
        label={messages.key(near + 1, keys.length)}
        value={100 * key.at}
        min={0}
        max={100}
        step={1}
        digits={1}
        unit="%"
        onChange={(percentage) => {
          pausePhase();
          changeDeformation((d) => withKeyAt(d, near, percentage / 100), { gesture: `key ${near}` });
        }}
        onDone={endGesture}
      />
      <IconButton
        icon="bin"
        label={messages.deleteKey(near + 1)}
        kind="quiet"
        disabled={alone}
        onClick={() => removeKey(near)}
      />
    </div>
  );
}

/** Keeps the mesh of the present moment. */
export function addKey(): void {
  pausePhase();
  const before = deformation.peek();
  changeDeformation((d) => withKey(d, d.phase, movesAt(d.keys, d.phase, d.loop)));
  const after = deformation.peek();
  if (after === before) return;
  announce(messages.keyIsAt(percentWords(after.phase), keyNear(after, after.phase) + 1, after.keys.length));
}

export function removeKey(index: number): void {
  if (deformation.peek().keys.length < 2) return;
  pausePhase();
  changeDeformation((d) => withoutKey(d, index));
  announce(messages.keyDeleted(index + 1, deformation.peek().keys.length));
}

import { endGesture } from "#document/scene";
import { changeTimeline } from "#document/space/edits";
import { lookingAround, space, timeline } from "#document/space/space";
import { Button, IconButton } from "#ui/controls/Button";
import { MOST_KEYS, withKeyAt } from "../changes";
import { pauseSpace, scrubSpace } from "../clock";
import { MomentField, type Problems } from "../TimeNumbers";
import timeCss from "../time.module.css";
import { EaseMenu } from "./EaseMenu";
import { keyHere } from "./Keys";
import { attempt, removeKey, setKey } from "./keys";

/** Of the key at the present moment; where there is none, or another view, one can be made. */
export function KeyOptions({ problems }: Problems) {
  const line = timeline.value;
  const here = keyHere.value;
  const key = line?.keys[here];
  if (!line || !key || lookingAround.value) return <SetKey />;
  return (
    <div class={timeCss["key-numbers"]}>
      <MomentField
        {...(problems ? { problems } : {})}
        label={`Key ${here + 1} of ${line.keys.length}`}
        value={key.at}
        seconds={line.seconds}
        onChange={(to) => {
          pauseSpace();
          attempt(() => changeTimeline((now) => withKeyAt(now, here, to), { gesture: `space key ${here}` }));
          scrubSpace(timeline.peek()?.keys[here]?.at ?? to);
        }}
        onDone={endGesture}
      />
      <EaseMenu of={key} index={here} />
      <IconButton icon="bin" label={`Delete key ${here + 1}`} kind="quiet" onClick={() => removeKey(here)} />
    </div>
  );
}

/** Keeps what is now. */
export function SetKey({ short = false }: { short?: boolean }) {
  const line = timeline.value;
  const full = line !== null && line.keys.length >= MOST_KEYS && keyHere.value < 0;
  const description = full
    ? `There are ${MOST_KEYS} keys already`
    : "Keep the view, the place of each object and the morph at this moment";
  if (short) {
    return (
      <IconButton
        icon="add"
        label="Set key"
        description="keep what is now at this moment"
        disabled={full || !space.value}
        command="key"
        onClick={setKey}
      />
    );
  }
  return (
    <Button
      class={timeCss["set-key"]}
      icon="add"
      kind={lookingAround.value ? "primary" : "plain"}
      disabled={full || !space.value}
      description={description}
      command="key"
      onClick={setKey}
    >
      {lookingAround.value ? "Set key to this view" : "Set key"}
    </Button>
  );
}

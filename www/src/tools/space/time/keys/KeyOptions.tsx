import { endGesture } from "#document/scene";
import { changeTimeline } from "#document/space/edits";
import { lookingAround, space, timeline } from "#document/space/space";
import { Button, IconButton } from "#ui/controls/Button";
import { Menu } from "#ui/overlay/Menu";
import type { SpaceKey } from "#wasm/api";
import { pauseSpace, scrubSpace } from "../clock";
import * as messages from "../messages";
import { MomentField, type Problems } from "../TimeFields";
import timeCss from "../time.module.css";
import { MOST_KEYS, withEase, withKeyAt } from "../time-edits";
import { EASES, easeWords } from "../time-text";
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
        label={messages.keyOf(here + 1, line.keys.length)}
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
      <IconButton
        icon="bin"
        label={messages.deleteKey(here + 1)}
        kind="quiet"
        onClick={() => removeKey(here)}
      />
    </div>
  );
}

/** Keeps what is now. */
export function SetKey({ short = false }: { short?: boolean }) {
  const line = timeline.value;
  const full = line !== null && line.keys.length >= MOST_KEYS && keyHere.value < 0;
  const description = full ? messages.keysFull(MOST_KEYS) : messages.keepsViewPlaceEach;
  if (short) {
    return (
      <IconButton
        icon="add"
        label={messages.setKeyframe2}
        description={messages.keepCurrentStateAt}
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
      {lookingAround.value ? messages.setKeyframeToThis : messages.setKeyframe2}
    </Button>
  );
}

/** How it goes on from a key to the next one. */
export function EaseMenu({ of, index }: { of: SpaceKey; index: number }) {
  return (
    <div title={messages.easeFrom(index + 1, easeWords(of.ease))}>
      <Menu
        label={messages.easeAfter(index + 1, easeWords(of.ease))}
        icon="arrow"
        items={EASES.map(({ value, label }) => ({
          label,
          ...(value === of.ease ? { icon: "check" as const } : {}),
          onSelect: () => attempt(() => changeTimeline((line) => withEase(line, index, value))),
        }))}
      />
    </div>
  );
}

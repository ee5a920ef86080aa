import { computed } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { changeTimeline } from "#document/space/edits";
import { moment, timeline } from "#document/space/space";
import { KeyTrack } from "#ui/strip/KeyTrack";
import type { SpaceTimeline } from "#wasm/api";
import { pauseSpace, scrubSpace } from "../clock";
import * as messages from "../messages";
import timeCss from "../time.module.css";
import { keyAt, withKeyAt } from "../time-edits";
import { easeWords, keyWords, secondsWords } from "../time-text";
import { attempt, removeKey } from "./keys";
import { keyPictures } from "./pictures";

/** The key at the present moment, or -1. */
export const keyHere = computed(() => (timeline.value ? keyAt(timeline.value, moment.value) : -1));
/** That of the moment, or the last before it. */
const reach = computed(() => {
  const keys = timeline.value?.keys ?? [];
  return Math.max(
    0,
    keyHere.value >= 0 ? keyHere.value : keys.findLastIndex((key) => key.at <= moment.value),
  );
});

function go(index: number): void {
  const key = timeline.peek()?.keys[index];
  if (key) scrubSpace(key.at);
}

function move(index: number, to: number): void {
  pauseSpace();
  attempt(() => changeTimeline((now) => withKeyAt(now, index, to), { gesture: `space key ${index}` }));
  go(index);
}

/** The keys of the time line, each with what is seen then. */
export function Keys({ line }: { line: SpaceTimeline }) {
  const here = keyHere.value;
  return (
    <KeyTrack
      label={messages.keyframes}
      keys={line.keys}
      length={line.seconds}
      here={here}
      reach={reach.value}
      step={0.1}
      about={(index) => {
        const key = line.keys[index];
        if (!key) return {};
        const words = messages.keyAbout(secondsWords(key.at), keyWords(key), easeWords(key.ease));
        return {
          "aria-label": messages.keyOfAt(index + 1, line.keys.length, words),
          title: messages.keyKeys(index + 1, words),
          ...(index === here ? { "aria-current": "true" as const } : {}),
        };
      }}
      go={go}
      move={move}
      remove={removeKey}
      Picture={KeyPicture}
    />
  );
}

/** What is seen at a key, small. */
function KeyPicture({ index }: { index: number }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const image = keyPictures.value[index] ?? null;
  useLayoutEffect(() => {
    const element = canvas.current;
    if (!element) return;
    element.width = image?.width ?? 1;
    element.height = image?.height ?? 1;
    if (image) element.getContext("2d")?.putImageData(image, 0, 0);
  }, [image]);
  return (
    <span class={timeCss["key-picture"]} aria-hidden="true">
      <canvas ref={canvas} />
    </span>
  );
}

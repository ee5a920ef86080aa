/** What is done with keys, by whichever button or key of the keyboard. */
import { announce, notify, wordsOf } from "#document/notice";
import { addKey, changeTimeline, EMPTY_LINE, endTimeline } from "#document/space/edits";
import { moment, space, timeline } from "#document/space/space";
import { pauseSpace, scrubSpace } from "../clock";
import * as messages from "../messages";
import { keyAt, MOST_KEYS, momentIn, nextKey, stretched, withoutKey } from "../time-edits";
import { keyWords, secondsWords } from "../time-text";

/** Does something to the document, or says why it could not be done. Whether it was. */
export function attempt(change: () => void): boolean {
  try {
    change();
    return true;
  } catch (problem) {
    notify({ kind: "error", text: wordsOf(problem) });
    return false;
  }
}

/** Keeps all that is now at this moment. */
export function setKey(): void {
  pauseSpace();
  const line = timeline.peek();
  // A moment that was never on this time line.
  const at = momentIn(line ?? space.peek()?.timeline ?? EMPTY_LINE, moment.peek());
  if (at !== moment.peek()) scrubSpace(at);
  if (line && line.keys.length >= MOST_KEYS && keyAt(line, at) < 0) {
    notify({ kind: "error", text: messages.keysLimit(MOST_KEYS) });
    return;
  }
  attempt(() => {
    addKey();
    const after = timeline.peek();
    const index = after ? keyAt(after, at) : -1;
    const key = after?.keys[index];
    if (after && key) {
      announce(messages.keySet(index + 1, after.keys.length, secondsWords(at), keyWords(key)));
    }
  });
}

export function removeKey(index: number): void {
  pauseSpace();
  const last = timeline.peek()?.keys.length === 1;
  if (!attempt(() => (last ? endTimeline() : changeTimeline((line) => withoutKey(line, index))))) return;
  const left = timeline.peek()?.keys.length ?? 0;
  announce(
    messages.keyDeleted(index + 1, left === 0 ? messages.nothingMovesAnyMore : messages.keysLeft(left)),
  );
}

/** All keys go; what is seen now stays. */
export function removeAllKeys(): void {
  pauseSpace();
  if (!attempt(endTimeline)) return;
  notify({ kind: "info", text: messages.allKeyframesRemovedAnd });
}

export function goToKey(by: 1 | -1): void {
  const line = timeline.peek();
  if (line) scrubSpace(nextKey(line, moment.peek(), by));
}

export function stretch(factor: number): void {
  const before = timeline.peek();
  if (!before) return;
  pauseSpace();
  const at = moment.peek();
  attempt(() => changeTimeline((line) => stretched(line, factor)));
  const after = timeline.peek();
  if (!after || after === before) {
    notify({ kind: "info", text: messages.thisWouldTooLong });
    return;
  }
  scrubSpace(at * factor);
  announce(messages.timelineNow(secondsWords(after.seconds)));
}

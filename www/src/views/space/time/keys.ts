/** What is done with keys, by whichever button or key of the keyboard. */
import { announce, notify, wordsOf } from "../../../state/notice";
import { moment, space, timeline } from "../../../state/space";
import { addKey, changeTimeline, EMPTY_LINE } from "../../../state/space-edits";
import { keyAt, MOST_KEYS, momentIn, nextKey, stretched, withoutKey } from "./changes";
import { pauseSpace, scrubSpace } from "./clock";
import { keyWords, secondsWords } from "./words";

/** Does something to the document, or says why it could not be done. */
export function attempt(change: () => void): void {
  try {
    change();
  } catch (problem) {
    notify({ kind: "error", text: wordsOf(problem) });
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
    notify({ kind: "error", text: `There are ${MOST_KEYS} keys already. Delete one first.` });
    return;
  }
  attempt(() => {
    addKey();
    const after = timeline.peek();
    const index = after ? keyAt(after, at) : -1;
    const key = after?.keys[index];
    if (after && key) {
      announce(`Key ${index + 1} of ${after.keys.length} at ${secondsWords(at)}: ${keyWords(key)}.`);
    }
  });
}

export function removeKey(index: number): void {
  pauseSpace();
  attempt(() => changeTimeline((line) => withoutKey(line, index)));
  const left = timeline.peek()?.keys.length ?? 0;
  announce(`Key ${index + 1} deleted. ${left === 0 ? "Nothing moves any more." : `${left} left.`}`);
}

/** All keys go, and what they said with them. */
export function removeAllKeys(): void {
  pauseSpace();
  attempt(() => changeTimeline(() => EMPTY_LINE));
  notify({ kind: "info", text: "All keys are gone. Undo brings them back." });
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
    notify({ kind: "info", text: "That would be too long, too short, or keys would meet." });
    return;
  }
  scrubSpace(at * factor);
  announce(`The time line is ${secondsWords(after.seconds)} long now.`);
}

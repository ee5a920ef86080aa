import { dismiss, notify, wordsOf } from "#document/notice";
import * as messages from "../messages";

/** What a picture is drawn for, as a notice says it, and the beginning of what is said where that fails. */
const PURPOSES = {
  save: messages.pictureCouldNotSaved,
  print: messages.pictureCouldNotPrinted,
} as const;

/** Has a picture drawn: says so while it takes, lets it be called off, and tells what went wrong. */
export async function whileDrawn(
  purpose: keyof typeof PURPOSES,
  make: (signal: AbortSignal, dismissed: () => void) => Promise<void>,
): Promise<void> {
  const calledOff = new AbortController();
  const notice = notify({
    kind: "info",
    text: messages.drawingTo(purpose),
    action: { label: messages.cancel, run: () => calledOff.abort() },
    stays: true,
  });
  try {
    await make(calledOff.signal, () => dismiss(notice));
  } catch (problem) {
    if (calledOff.signal.aborted) return;
    notify({ kind: "error", text: `${PURPOSES[purpose]}: ${wordsOf(problem)}` });
  } finally {
    dismiss(notice);
  }
}

import { dismiss, notify, wordsOf } from "#document/notice";

/** Has a picture made to be saved: says so while it takes, lets it be called off, and tells what went wrong. */
export async function whileDrawn(make: (signal: AbortSignal) => Promise<void>): Promise<void> {
  const calledOff = new AbortController();
  const notice = notify({
    kind: "info",
    text: "Drawing the picture to save …",
    action: { label: "Cancel", run: () => calledOff.abort() },
    stays: true,
  });
  try {
    await make(calledOff.signal);
  } catch (problem) {
    if (calledOff.signal.aborted) return;
    notify({ kind: "error", text: `The picture could not be saved: ${wordsOf(problem)}` });
  } finally {
    dismiss(notice);
  }
}

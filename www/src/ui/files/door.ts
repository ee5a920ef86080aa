/** The one door for files: whatever asks for one, drops one or pastes one hands it to who is named here. */

type Take = (files: readonly [File, ...File[]]) => void;

let taken: Take | null = null;
/** What came before there was anybody to take it. */
let waiting: Parameters<Take>[0] | null = null;

/** Names who takes files, until the returned function is called. */
export function takeFiles(take: Take): () => void {
  taken = take;
  if (waiting) take(waiting);
  waiting = null;
  return () => {
    if (taken === take) taken = null;
  };
}

export const openFile: Take = (files) => {
  if (taken) taken(files);
  else waiting = files;
};

/** Asks for files and opens them. */
export function askForFile(accept = ""): void {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = accept;
  input.addEventListener("change", () => {
    const [first, ...others] = input.files ?? [];
    if (first) openFile([first, ...others]);
  });
  input.click();
}

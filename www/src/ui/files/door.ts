/** The one door for files: whatever asks for one, drops one or pastes one hands it to who is named here. */

type Take = (files: readonly [File, ...File[]]) => void;

let taken: Take | null = null;

/** Names who takes files, until the returned function is called. */
export function takeFiles(take: Take): () => void {
  taken = take;
  return () => {
    if (taken === take) taken = null;
  };
}

export const openFile: Take = (files) => taken?.(files);

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

import "./drop-files.css";

/** Takes files that are dropped on the page or pasted into it. Returns the end of it. */
export function listenForFiles(take: (files: readonly [File, ...File[]]) => void): () => void {
  const end = new AbortController();
  const { signal } = end;
  const stage = () => [...document.querySelectorAll(".stage")].at(-1);
  // Entering a child comes before leaving its parent: they are counted.
  let inside = 0;
  const mark = (by: number) => {
    inside = Math.max(0, inside + by);
    stage()?.classList.toggle("dropping", inside > 0);
  };
  const carries = (event: DragEvent) => event.dataTransfer?.types.includes("Files") === true;
  const hand = (files: FileList | undefined) => {
    const [first, ...others] = files ?? [];
    if (first) take([first, ...others]);
  };

  document.addEventListener("dragenter", (event) => carries(event) && mark(1), { signal });
  document.addEventListener("dragleave", (event) => carries(event) && mark(-1), { signal });
  document.addEventListener(
    "dragover",
    (event) => {
      // Without this the browser would leave the page for the file.
      if (carries(event)) event.preventDefault();
    },
    { signal },
  );
  document.addEventListener(
    "drop",
    (event) => {
      if (!carries(event)) return;
      event.preventDefault();
      mark(-inside);
      hand(event.dataTransfer?.files);
    },
    { signal },
  );
  document.addEventListener(
    "paste",
    (event) => {
      const files = event.clipboardData?.files;
      if (!files?.length) return;
      event.preventDefault();
      hand(files);
    },
    { signal },
  );
  return () => {
    end.abort();
    mark(-inside);
  };
}

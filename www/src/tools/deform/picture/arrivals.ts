import { takeFile } from "./take";

/** Takes pictures that are dropped on the page or pasted into it. Returns the end of it. */
export function listenForPictures(): () => void {
  const end = new AbortController();
  const { signal } = end;
  const stage = () => document.querySelector(".stage");
  // Entering a child comes before leaving its parent: they are counted.
  let inside = 0;
  const mark = (by: number) => {
    inside = Math.max(0, inside + by);
    stage()?.classList.toggle("dropping", inside > 0);
  };
  const carries = (event: DragEvent) => event.dataTransfer?.types.includes("Files") === true;

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
      take(event.dataTransfer?.files);
    },
    { signal },
  );
  document.addEventListener(
    "paste",
    (event) => {
      const files = event.clipboardData?.files;
      if (!files?.length) return;
      event.preventDefault();
      take(files);
    },
    { signal },
  );
  return () => {
    end.abort();
    mark(-inside);
  };
}

/** The first of several that is called a picture, or else the first. */
function take(files: FileList | undefined): void {
  const all = [...(files ?? [])];
  const file = all.find((one) => one.type.startsWith("image/")) ?? all[0];
  if (file) void takeFile(file, file.name);
}

/** Does this on Escape, wherever the focus is, unless something nearer has taken the key or a dialog is open. */
export function listenForEscape(run: () => void): () => void {
  const onKey = (event: KeyboardEvent) => {
    if (event.key !== "Escape" || event.defaultPrevented || document.querySelector("dialog[open]")) return;
    // One press closes one thing.
    event.preventDefault();
    run();
  };
  document.addEventListener("keydown", onKey);
  return () => document.removeEventListener("keydown", onKey);
}

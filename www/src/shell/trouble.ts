import { isUnfetched, loadAgain, notify, wordsOf } from "#document/notice";

/** Whatever nobody caught is said, never swallowed. */
export function reportTrouble(): void {
  addEventListener("error", (event) => {
    // Browsers report a resize that took two rounds as an error; nothing is wrong then.
    if (event.message?.includes("ResizeObserver loop")) return;
    if (event.error || event.message) say(event.error ?? event.message);
  });
  addEventListener("unhandledrejection", (event) => say(event.reason));
}

function say(problem: unknown): void {
  const words = wordsOf(problem);
  const text = isUnfetched(problem) ? words : `Something went wrong: ${words}`;
  notify({ kind: "error", text, action: loadAgain });
}

/** Frond could not start at all: says why, and what to do, in place of the page. */
export function showFailure(root: HTMLElement, problem: unknown): void {
  const box = document.createElement("main");
  box.className = "failure";
  const title = document.createElement("h1");
  title.textContent = "Frond could not start";
  const why = document.createElement("p");
  why.textContent = wordsOf(problem);
  const todo = document.createElement("p");
  todo.textContent =
    typeof WebAssembly === "undefined"
      ? "This browser does not run WebAssembly, or it is switched off. A current Firefox, Chrome, Edge or Safari does."
      : "Reloading may help. If it does not, a current Firefox, Chrome, Edge or Safari should do.";
  const again = document.createElement("button");
  again.type = "button";
  again.className = "button primary";
  again.textContent = "Reload";
  again.onclick = () => location.reload();
  box.append(title, why, todo, again);
  root.replaceChildren(box);
}

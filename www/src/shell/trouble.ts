import { isUnfetched, loadAgain, notify, wordsOf } from "#document/notice";
import * as messages from "./messages";

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
  const text = isUnfetched(problem) ? words : messages.somethingWentWrong(words);
  notify({ kind: "error", text, action: loadAgain });
}

/** Frond could not start at all: says why, and what to do, in place of the page. */
export function showFailure(root: HTMLElement, problem: unknown): void {
  const box = document.createElement("main");
  box.className = "failure";
  const title = document.createElement("h1");
  title.textContent = messages.frondCouldNotStart;
  const why = document.createElement("p");
  why.textContent = wordsOf(problem);
  const todo = document.createElement("p");
  todo.textContent =
    typeof WebAssembly === "undefined" ? messages.thisBrowserDoesNot : messages.reloadPageIfDoes;
  const again = document.createElement("button");
  again.type = "button";
  again.className = "button primary";
  again.textContent = messages.reload;
  again.onclick = () => location.reload();
  box.append(title, why, todo, again);
  root.replaceChildren(box);
}

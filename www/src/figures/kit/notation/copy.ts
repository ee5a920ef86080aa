import { notify } from "#document/notice";

/** Where a paragraph or a cell ends, a line of what is copied does. */
const LINES = "p, li, tr, h1, h2, h3, dt, dd, blockquote, figcaption, div";

/** What is selected, with its formulas as LaTeX; null where there are none, and the browser copies as ever. */
function selectedText(selection: Selection): { text: string; html: string } | null {
  if (selection.isCollapsed || selection.rangeCount === 0) return null;
  const range = selection.getRangeAt(0);
  const around = range.commonAncestorContainer;
  const inside = (around instanceof Element ? around : around.parentElement)?.closest("[data-tex]");
  if (inside instanceof HTMLElement) return { text: inside.dataset["tex"] ?? "", html: inside.innerHTML };
  const box = document.createElement("div");
  box.append(range.cloneContents());
  const html = box.innerHTML;
  const formulas = box.querySelectorAll<HTMLElement>("[data-tex]");
  if (formulas.length === 0) return null;
  for (const button of box.querySelectorAll("button")) button.remove();
  for (const formula of formulas) formula.replaceWith(`$${formula.dataset["tex"]}$`);
  for (const line of box.querySelectorAll(LINES)) line.append("\n");
  return { text: (box.textContent ?? "").replace(/\s*\n\s*/g, "\n").trim(), html };
}

/** Copies what is selected so that formulas arrive as LaTeX where there is plain text, and else as MathML. */
export function copySelection(event: ClipboardEvent): void {
  const selection = getSelection();
  const copied = selection && event.clipboardData ? selectedText(selection) : null;
  if (!copied) return;
  event.clipboardData?.setData("text/plain", copied.text);
  event.clipboardData?.setData("text/html", copied.html);
  event.preventDefault();
}

export async function copyTex(tex: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(tex);
    notify({ kind: "info", text: "The formula is copied as LaTeX." });
  } catch {
    notify({ kind: "error", text: `Copying was not allowed here. In LaTeX it is: ${tex}` });
  }
}

/**
 * A page that the browser translates keeps its words true. A translator (Chrome's, Edge's) puts an element of its own
 * in the place of each text node, and Preact goes on changing a node that nobody sees. So the node is put back before
 * the translation, empty: when Preact writes into it, moves it or takes it away, the translation goes, and the
 * translator finds new text to translate.
 */

const TRANSLATION = "FONT";

interface Translated {
  translation: Element;
  /** What the node said. */
  text: string;
}

/** Watches the page, from its start on. */
export function keepTranslationsTrue(root: Node): void {
  const translated = new Map<Node, Translated>();
  const taken = new WeakSet<Element>();
  let watching = false;

  /** The element that came in the place of a text node that went. */
  const inPlaceOf = ({ addedNodes, previousSibling, nextSibling }: MutationRecord): Element | null => {
    for (const node of [...addedNodes, previousSibling, nextSibling])
      if (node instanceof Element && node.nodeName === TRANSLATION && !taken.has(node) && node.isConnected)
        return node;
    return null;
  };

  const takeBack = (node: Node): Translated | undefined => {
    const one = translated.get(node);
    one?.translation.remove();
    translated.delete(node);
    return one;
  };

  const removed = (node: Node, record: MutationRecord): void => {
    const one = takeBack(node);
    // It was moved: what it says is translated anew.
    if (one && node.isConnected) node.textContent = one.text;
    const translation = one || node.isConnected ? null : inPlaceOf(record);
    if (!translation) return;
    taken.add(translation);
    translated.set(node, { translation, text: node.textContent ?? "" });
    translation.before(node);
    node.textContent = "";
    if (watching) return;
    watching = true;
    observer.observe(root, { childList: true, characterData: true, subtree: true });
  };

  const observer = new MutationObserver((records) => {
    for (const record of records) {
      if (record.type === "characterData") takeBack(record.target);
      for (const node of record.removedNodes) {
        if (node.nodeType === Node.TEXT_NODE) removed(node, record);
        else for (const text of translated.keys()) if (node.contains(text)) translated.delete(text);
      }
    }
    // What was done here is nobody else's change.
    observer.takeRecords();
  });
  observer.observe(root, { childList: true, subtree: true });
}

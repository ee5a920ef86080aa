/** Two fingers over a picture of which one is at a handle: both are for the picture. */

/** What a handle lies over, and what is pinched and moved there. */
export const pictureUnder = (handle: Element): HTMLElement | null =>
  areaOf(handle)?.querySelector<HTMLElement>(".picture") ?? handle.closest<HTMLElement>("[role=application]");

const areaOf = (element: Element) => element.closest<HTMLElement>(".pane");

/** A finger that came down at a handle is the picture's from now on. */
export function handOver(
  picture: HTMLElement,
  { pointerId, pointerType, clientX, clientY }: PointerEvent,
): void {
  const told = { pointerId, pointerType, clientX, clientY, button: 0 };
  picture.dispatchEvent(new PointerEvent("pointerdown", told));
}

/**
 * Tells when another finger than this one comes down over the picture, before anything else hears of it; one at a
 * handle is handed over. Returns the end of it.
 */
export function otherFinger(
  picture: HTMLElement,
  pointerId: number,
  comes: (picture: HTMLElement) => void,
): () => void {
  const area = areaOf(picture) ?? picture;
  const listening = new AbortController();
  const down = (event: PointerEvent) => {
    const { target, pointerType } = event;
    if (event.pointerId === pointerId || pointerType !== "touch" || !(target instanceof Element)) return;
    comes(picture);
    if (!target.closest("[data-handle]")) return;
    event.stopPropagation();
    handOver(picture, event);
  };
  area.addEventListener("pointerdown", down, { capture: true, signal: listening.signal });
  return () => listening.abort();
}

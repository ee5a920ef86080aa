import { useEffect, useRef } from "preact/hooks";
import { endGesture, takeBack } from "#document/scene";
import { type Screen, screen } from "#geometry/coordinates";
import { placeIn } from "#ui/panZoom";
import { handOver, otherFinger, pictureUnder } from "./pinch";

/** Something in an SVG that is dragged, and moved by keys. Places are CSS pixels from its upper left. */
export interface Grip {
  /** Where it is when it is taken hold of; null where it is gone. */
  take(event: PointerEvent): Screen | null;
  /** `free` where Alt is held. */
  moveTo(to: Screen, free: boolean): void;
  /** True when the key was one of its own. */
  key(event: KeyboardEvent): boolean;
  focus?(): void;
}

/** Its listeners, for the `ref` of its element. */
export function useGrip(grip: Grip): (node: SVGElement | null) => void {
  const element = useRef<SVGElement | null>(null);
  const latest = useRef(grip);
  latest.current = grip;
  useEffect(() => (element.current ? attachGrip(element.current, () => latest.current) : undefined), []);
  return (node) => {
    element.current = node;
  };
}

/**
 * Listens until it is told to stop; each drag and each key held is one step of undo. Where a second finger comes both
 * are for the picture, and what the first has changed is taken back.
 */
export function attachGrip(node: SVGElement, grip: () => Grip): () => void {
  const listening = new AbortController();
  const { signal } = listening;
  /** From the pointer to the grip, so that it does not jump. */
  let offset: Screen | null = null;
  const pointer = (event: PointerEvent) => placeIn(node.ownerSVGElement ?? node, event);
  /** No longer waits for a second finger. */
  let alone = () => {};
  let last: PointerEvent | null = null;
  const down = (event: PointerEvent) => {
    const picture = event.pointerType === "touch" ? pictureUnder(node) : null;
    if (picture?.dataset["dragging"] !== undefined) {
      event.stopPropagation();
      handOver(picture, event);
      return;
    }
    const at = event.button === 0 ? grip().take(event) : null;
    if (!at) return;
    const from = pointer(event);
    offset = screen(at.x - from.x, at.y - from.y);
    node.setPointerCapture(event.pointerId);
    last = event;
    if (picture) alone = otherFinger(picture, event.pointerId, joined);
  };
  /** A second finger has come. */
  const joined = (picture: HTMLElement) => {
    const first = last;
    offset = null;
    alone();
    takeBack();
    if (first) handOver(picture, first);
  };
  const move = (event: PointerEvent) => {
    if (!offset) return;
    last = event;
    const { x, y } = pointer(event);
    grip().moveTo(screen(x + offset.x, y + offset.y), event.altKey);
  };
  const up = () => {
    alone();
    if (offset) endGesture();
    offset = null;
  };
  const key = (event: KeyboardEvent) => {
    if (!grip().key(event)) return;
    event.preventDefault();
    event.stopPropagation();
  };
  node.addEventListener("pointerdown", down, { signal });
  node.addEventListener("pointermove", move, { signal });
  node.addEventListener("pointerup", up, { signal });
  node.addEventListener("pointercancel", up, { signal });
  node.addEventListener("keydown", key, { signal });
  node.addEventListener("keyup", endGesture, { signal });
  node.addEventListener("blur", endGesture, { signal });
  node.addEventListener("focus", () => grip().focus?.(), { signal });
  return () => {
    alone();
    listening.abort();
  };
}

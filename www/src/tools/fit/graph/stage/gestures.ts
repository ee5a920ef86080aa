/** Mouse, finger, wheel and keys on the stage: along t. */
import { attachPanZoom, type PanZoom, panZoomKey } from "#ui/panZoom";
import { panBy, showAll, span, zoomAbout } from "../model/span";
import { leftOf, tAt } from "./frame";
import { frame } from "./shown";

/** How far a key moves it, in parts of what is shown. */
const KEY_PAN = 0.06;

const GRAPH: PanZoom = {
  flat: true,
  pan: (dx) => panBy(-dx / frame.peek().width),
  zoom: (factor, about) => zoomAbout(factor, about && tAt(frame.peek(), about.x)),
  fit: showAll,
};

/** Pan, pinch and wheel. Returns the end of it. `onTap`: a press that moved nothing. */
export function attachGestures(element: HTMLElement, onTap: (left: number, top: number) => void): () => void {
  return attachPanZoom(element, { ...GRAPH, tap: ({ x, y }) => onTap(x, y) });
}

/** Keys on the focused stage. True when the key was one of them. */
export const stageKey = (event: KeyboardEvent): boolean =>
  panZoomKey(event, GRAPH, KEY_PAN * frame.peek().width);

/** Whether t lies on the stage. */
export function isShown(t: number): boolean {
  const [from, to] = span.value;
  return t >= from && t <= to && Number.isFinite(leftOf(frame.value, t));
}

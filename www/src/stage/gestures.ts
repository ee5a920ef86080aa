/** Hands and keys on the picture: they move and enlarge the view. */
import { refitEdited } from "#document/editing/frame";
import { panned, type Screen, screen, zoomed } from "#geometry/coordinates";
import { attachPanZoom, type PanZoom, panZoomKey } from "#ui/panZoom";
import { effectiveView, fitView, stageSize, view } from "./view";
import { keepView } from "./view-link";

/** What a tap on the picture does, while somebody asks for one. */
export const pictureTap: { does: ((at: Screen) => void) | null } = { does: null };

const PICTURE: PanZoom = {
  pan(dx, dy) {
    view.value = panned(effectiveView.peek(), dx, dy);
  },
  zoom: zoomBy,
  fit: fitStage,
  rest: keepView,
  // Without it a drag moves the picture from its first pixel on.
  get tap() {
    return pictureTap.does ?? undefined;
  },
};

/** Pan, pinch and wheel on one picture. Returns the end of it. */
export const attachGestures = (element: HTMLElement): (() => void) => attachPanZoom(element, PICTURE);

/** Keys on the focused stage. True when the key was one of them. */
export const stageKey = (event: KeyboardEvent): boolean => panZoomKey(event, PICTURE);

export function zoomBy(factor: number, about?: Screen): void {
  const size = stageSize.peek();
  const point = about ?? screen(size.width / 2, size.height / 2);
  view.value = zoomed(effectiveView.peek(), factor, point, size, fitView.peek().scale);
}

export function fitStage(): void {
  refitEdited();
  view.value = null;
  keepView();
}

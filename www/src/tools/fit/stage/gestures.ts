/** Pan, pinch, wheel and brush on the stage of the fit. */
import type { Screen } from "#geometry/coordinates";
import { attachPanZoom, type PanZoom, panZoomKey, placeIn } from "#ui/panZoom";
import { chooseNear } from "../copies/copies";
import { frame } from "../work/outline";
import { opened } from "../work/source";
import { beginStroke, cursor, dropStroke, endStroke, goOn, painting } from "./brush";
import { effectiveView, fitStage, panBy, under, zoomBy } from "./camera";

const PICTURE: PanZoom = { pan: panBy, zoom: zoomBy, fit: fitStage };

/** The pixel of the picture under a point of the stage. */
function pixelUnder(at: Screen): { x: number; y: number } {
  const { x, y } = under(at);
  const { scale, x: fx, y: fy } = frame.peek();
  const height = opened.peek()?.height ?? 0;
  return { x: x / scale + fx, y: height - (y / scale + fy) };
}

/** How near the pointer comes to a copy that it means, in CSS pixels. */
const NEAR = 14;

function lookAt(at: Screen): void {
  const { x, y } = under(at);
  chooseNear(x, y, NEAR / effectiveView.peek().scale);
}

/** Returns the end of it. */
export function attachGestures(element: HTMLElement): () => void {
  const listening = new AbortController();
  const { signal } = listening;
  const pixelAt = (event: PointerEvent) => pixelUnder(placeIn(element, event));

  // Before the stroke goes on.
  element.addEventListener(
    "pointermove",
    (event) => {
      if (painting.peek()) cursor.value = pixelAt(event);
      else if (event.buttons === 0 && event.pointerType !== "touch") lookAt(placeIn(element, event));
    },
    { signal },
  );
  element.addEventListener(
    "pointerleave",
    () => {
      if (element.dataset["dragging"] === undefined && document.activeElement !== element)
        cursor.value = null;
    },
    { signal },
  );

  const end = attachPanZoom(element, {
    ...PICTURE,
    fit() {
      if (!painting.peek()) fitStage();
    },
    tap: lookAt,
    // The middle button moves the picture, whatever is in hand.
    takes: ({ button, target }) => button <= 1 && !(target as Element).closest("button"),
    begin(event) {
      if (event.button === 1) event.preventDefault();
      if (!painting.peek() || event.button !== 0) return null;
      const place = pixelAt(event);
      cursor.value = place;
      beginStroke(place);
      return {
        move(event) {
          const all = event.getCoalescedEvents?.() ?? [];
          for (const one of all.length > 0 ? all : [event]) goOn(pixelAt(one));
        },
        // A second finger comes to enlarge: what the first began is no stroke.
        end(done) {
          if (done) endStroke();
          else dropStroke();
        },
      };
    },
  });
  return () => {
    listening.abort();
    end();
    dropStroke();
  };
}

/** Keys on the focused stage while nothing is painted. True when the key was one of them. */
export const stageKey = (event: KeyboardEvent): boolean => panZoomKey(event, PICTURE);

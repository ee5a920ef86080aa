/**
 * A finger on a slider: a swipe up or down scrolls the page and leaves the value as it was. Browsers move the thumb
 * below a finger at once, before they can know which of the two is meant. So what a slider says waits until the finger
 * has gone sideways, or was lifted where it came down.
 */

/** From here on, in CSS pixels, a finger has a direction. */
const FAR = 5;

interface Waiting {
  slider: HTMLInputElement;
  id: number;
  x: number;
  y: number;
  /** Its value before it was touched. */
  before: string;
  /** What the browser has made of the touch. */
  wanted: string | null;
  /** It went up or down: what comes now is no tap. */
  along: boolean;
}

const sliderOf = ({ target }: Event) =>
  target instanceof HTMLInputElement && target.type === "range" ? target : null;

/** For all sliders of the page. Returns the end of it. */
export function waitForSwipes(page: EventTarget): () => void {
  const listening = new AbortController();
  const options = { capture: true, signal: listening.signal };
  let waiting: Waiting | null = null;

  const on = <E extends Event>(type: string, listener: (event: E) => void) =>
    page.addEventListener(type, listener as (event: Event) => void, options);

  on<PointerEvent>("pointerdown", (event) => {
    const slider = sliderOf(event);
    waiting = null;
    if (!slider || event.pointerType !== "touch") return;
    const { pointerId: id, clientX: x, clientY: y } = event;
    waiting = { slider, id, x, y, before: slider.value, wanted: null, along: false };
  });
  on("input", (event) => {
    if (!waiting || event.target !== waiting.slider) return;
    event.stopPropagation();
    waiting.wanted = waiting.slider.value;
    waiting.slider.value = waiting.before;
  });
  on<PointerEvent>("pointermove", (event) => {
    if (!waiting || event.pointerId !== waiting.id) return;
    const across = Math.abs(event.clientX - waiting.x);
    const along = Math.abs(event.clientY - waiting.y);
    if (Math.max(across, along) < FAR) return;
    if (along > across) waiting.along = true;
    else if (!waiting.along) waiting = null;
  });
  on<PointerEvent>("pointerup", (event) => {
    const tapped = waiting;
    if (!tapped || event.pointerId !== tapped.id) return;
    waiting = null;
    if (tapped.along || tapped.wanted === null) return;
    tapped.slider.value = tapped.wanted;
    tapped.slider.dispatchEvent(new Event("input", { bubbles: true }));
  });
  // The browser scrolls.
  on<PointerEvent>("pointercancel", (event) => {
    if (event.pointerId === waiting?.id) waiting = null;
  });
  return () => listening.abort();
}

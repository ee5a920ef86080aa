/** How a picture is moved and enlarged: by drag, pinch, wheel and keys, the same on every stage. */
import { type Screen, screen } from "#geometry/coordinates";

/** What a press does in place of moving the picture. */
export interface Stroke {
  move(event: PointerEvent, now: Screen, before: Screen): void;
  /** It was not `done` where a second finger came, or the browser took the pointer. */
  end(done: boolean): void;
}

/** A picture that can be moved and enlarged. Lengths are CSS pixels from the upper left of its element. */
export interface PanZoom {
  /** The picture goes along with the pointer. */
  pan(dx: number, dy: number): void;
  /** The point `about` stays where it is; without it the middle does. */
  zoom(factor: number, about?: Screen): void;
  /** All of it: a double press. */
  fit(): void;
  /** The last of a gesture has been done. */
  rest?(): void;
  /** Only along x: sideways on a touch pad moves, and two fingers count by how far they are apart there. */
  flat?: boolean;
  /** Whether a press is for the picture. By default one of the main button that is beside all handles. */
  takes?(event: MouseEvent): boolean;
  /** What the first pointer of a gesture begins instead. */
  begin?(event: PointerEvent, at: Screen): Stroke | null;
  /** A press that moved nothing, though it may tremble. */
  tap?: ((at: Screen) => void) | undefined;
}

const WHEEL_REST_MS = 250;
const STEP = 1.25;
const KEY_PAN = 48;
/** How far a tap may travel. */
const TREMBLE = 4;

/** The place of an event in an element. */
export function placeIn(element: Element, { clientX, clientY }: MouseEvent): Screen {
  const { left, top } = element.getBoundingClientRect();
  return screen(clientX - left, clientY - top);
}

/** How many pixels a wheel turned. */
const turned = (delta: number, { deltaMode }: WheelEvent) =>
  delta * (deltaMode === 1 ? 16 : deltaMode === 2 ? 400 : 1);

/**
 * What a wheel enlarges by: a pixel by so much. A pinch on a touch pad arrives as a wheel with Ctrl held, in smaller
 * steps.
 */
export function wheelFactor(event: WheelEvent, aPixel = 0.0016): number {
  return Math.exp(-turned(event.deltaY, event) * (event.ctrlKey ? 0.01 : aPixel));
}

/** Two fingers, of which one has moved: the point between them stays between them, their distance scales. */
export function pinched(before: Screen, now: Screen, other: Screen, least = 1, flat = false) {
  const apart = (p: Screen) => Math.max(least, Math.hypot(p.x - other.x, flat ? 0 : p.y - other.y));
  const middle = (p: Screen) => screen((p.x + other.x) / 2, (p.y + other.y) / 2);
  return { factor: apart(now) / apart(before), from: middle(before), to: middle(now) };
}

const besideHandles = ({ button, target }: MouseEvent) =>
  button === 0 && !(target instanceof Element && target.closest("[data-handle]") !== null);

/** Drags, pinches and the wheel on one picture. Returns the end of it. */
export function attachPanZoom(element: HTMLElement, picture: PanZoom): () => void {
  const { takes = besideHandles, flat = false } = picture;
  const end = new AbortController();
  const { signal } = end;
  const down = new Map<number, Screen>();
  let stroke: Stroke | null = null;
  let travelled = 0;
  let rest: ReturnType<typeof setTimeout> | undefined;

  const finish = (done: boolean) => {
    const ended = stroke;
    stroke = null;
    ended?.end(done);
  };

  const pointerdown = (event: PointerEvent) => {
    if (!takes(event)) return;
    element.setPointerCapture(event.pointerId);
    const at = placeIn(element, event);
    element.dataset["dragging"] = "";
    if (down.size === 0) {
      travelled = 0;
      stroke = picture.begin?.(event, at) ?? null;
    } else finish(false);
    down.set(event.pointerId, at);
  };

  const pointermove = (event: PointerEvent) => {
    const before = down.get(event.pointerId);
    if (!before) return;
    const now = placeIn(element, event);
    down.set(event.pointerId, now);
    travelled += Math.hypot(now.x - before.x, flat ? 0 : now.y - before.y);
    const other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (other) {
      const { factor, from, to } = pinched(before, now, other, flat ? 12 : 1, flat);
      picture.pan(to.x - from.x, to.y - from.y);
      picture.zoom(factor, to);
    } else if (stroke) stroke.move(event, now, before);
    else if (!picture.tap || travelled > TREMBLE) picture.pan(now.x - before.x, now.y - before.y);
  };

  const pointerup = (event: PointerEvent) => {
    if (!down.delete(event.pointerId) || down.size > 0) return;
    delete element.dataset["dragging"];
    const done = event.type === "pointerup";
    finish(done);
    if (done && travelled <= TREMBLE) picture.tap?.(placeIn(element, event));
    picture.rest?.();
  };

  const wheel = (event: WheelEvent) => {
    event.preventDefault();
    if (flat && Math.abs(event.deltaX) > Math.abs(event.deltaY) && !event.ctrlKey) {
      picture.pan(-turned(event.deltaX, event), 0);
    } else picture.zoom(wheelFactor(event), placeIn(element, event));
    clearTimeout(rest);
    rest = setTimeout(() => picture.rest?.(), WHEEL_REST_MS);
  };

  element.addEventListener("pointerdown", pointerdown, { signal });
  element.addEventListener("pointermove", pointermove, { signal });
  element.addEventListener("pointerup", pointerup, { signal });
  element.addEventListener("pointercancel", pointerup, { signal });
  element.addEventListener("wheel", wheel, { signal, passive: false });
  element.addEventListener("dblclick", (event) => takes(event) && picture.fit(), { signal });
  return () => {
    end.abort();
    clearTimeout(rest);
    finish(false);
  };
}

/** Keys on the focused stage. True when the key was one of them. */
export function panZoomKey(event: KeyboardEvent, picture: PanZoom, step = KEY_PAN): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey) return false;
  const far = step * (event.shiftKey ? 0.25 : 1);
  const across: Record<string, number> = { ArrowLeft: far, ArrowRight: -far };
  const along: Record<string, number> = picture.flat ? {} : { ArrowUp: far, ArrowDown: -far };
  const [dx, dy] = [across[event.key], along[event.key]];
  if (dx !== undefined || dy !== undefined) picture.pan(dx ?? 0, dy ?? 0);
  else if (event.key === "+" || event.key === "=") picture.zoom(STEP);
  else if (event.key === "-" || event.key === "_") picture.zoom(1 / STEP);
  else if (event.key === "0") picture.fit();
  else return false;
  picture.rest?.();
  return true;
}

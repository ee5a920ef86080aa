import type { RefObject } from "preact";
import { useEffect, useLayoutEffect, useRef } from "preact/hooks";
import { announce } from "#document/notice";
import { verdictLine, verdictPhrase } from "#format/verdict";
import type { Uv } from "#geometry/path";
import type { Bounds } from "#wasm/api";
import fieldCss from "../field.module.css";
import { place } from "../path/waypoints";
import { spot } from "../view/geometry";
import { inDigits, shownWindow, view } from "../view/view";
import { type Pointed, pointed, type Seen, SIDE, seen } from "./hover";

const REST_MS = 700;

/** Numbers of more letters than these have a line of their own. */
const LONG = 12;

/**
 * The attractor at the parameter that is pointed at, beside it: it takes nothing and hides nothing that is pointed at.
 */
export function Preview({ square }: { square: RefObject<HTMLElement | null> }) {
  return <Card now={pointed.value} known={seen.value} frame={shownWindow.value} square={square} />;
}

interface CardProps {
  now: Pointed | null;
  known: Seen | null;
  frame: Bounds;
  square: RefObject<HTMLElement | null>;
}

function Card({ now, known, frame, square }: CardProps) {
  const card = useRef<HTMLDivElement>(null);
  const open = now !== null && known !== null;
  useLayoutEffect(() => {
    const element = card.current;
    const box = square.current?.getBoundingClientRect();
    if (!element || !box) return;
    if (!open) {
      if (element.matches(":popover-open")) element.hidePopover();
      return;
    }
    if (!element.matches(":popover-open")) element.showPopover();
    const [x, y] = place(now.at, frame);
    const { left, top } = spot(
      { x: box.left + x * box.width, y: box.top + y * box.height },
      box,
      { width: element.offsetWidth, height: element.offsetHeight },
      { width: innerWidth, height: innerHeight },
      now.by === "touch",
    );
    element.style.left = `${left}px`;
    element.style.top = `${top}px`;
  }, [open, now, frame, square]);
  useSpoken(now?.by === "keys" ? known : null);
  return (
    <div ref={card} class="locus-preview" popover="manual" aria-hidden="true">
      {known && (
        <>
          <Bitmap bitmap={known.bitmap} />
          <p class={fieldCss["preview-verdict"]}>{verdictLine(known.answer, known.epsilon)}</p>
          <p class={`${fieldCss["preview-at"]} number`}>{parameterWords(known.at)}</p>
        </>
      )}
    </div>
  );
}

function parameterWords([u, v, w = 0]: Uv): string {
  if (view.value.family === "polygon") {
    return `s = ${inDigits(u)} ${v < 0 ? "−" : "+"} ${inDigits(Math.abs(v))} i`;
  }
  const wide = inDigits(u).length > LONG;
  return [`u ${inDigits(u)}`, `v ${inDigits(v)}`, ...(w === 0 ? [] : [`w ${inDigits(w)}`])].join(
    wide ? "\n" : "  ",
  );
}

function Bitmap({ bitmap }: { bitmap: ImageBitmap | null }) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useLayoutEffect(() => {
    const element = canvas.current;
    const context = element?.getContext("2d");
    if (!element || !context) return;
    context.clearRect(0, 0, element.width, element.height);
    // A picture that was let go in the meantime has no size.
    if (!bitmap || bitmap.width === 0) return;
    element.width = bitmap.width;
    element.height = bitmap.height;
    context.drawImage(bitmap, 0, 0);
  }, [bitmap]);
  return (
    <canvas ref={canvas} width={SIDE} height={SIDE} style={{ width: `${SIDE}px`, height: `${SIDE}px` }} />
  );
}

/** For those who move the cross and hear the page: what is there, once it has come to rest. */
function useSpoken(known: Seen | null) {
  useEffect(() => {
    if (!known?.answer) return;
    const text = `${parameterWords(known.at)}: ${verdictPhrase(known.answer, known.epsilon)}.`;
    const timer = setTimeout(() => announce(text), REST_MS);
    return () => clearTimeout(timer);
  }, [known]);
}

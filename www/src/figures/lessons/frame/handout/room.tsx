import "./handout.css";
import css from "./room.module.css";

/** Lines to write on, so many at least, and as many as the page has room for; on paper only. */
export function Room({ lines }: { lines: number }) {
  return <div class={css["room"]} style={{ "--lines": lines }} aria-hidden="true" />;
}

/** Squares of half a centimetre to draw on; on paper only. */
export function Squares() {
  return <div class={css["squares"]} aria-hidden="true" />;
}

/** Whose handout it is; on paper only. */
export function Whose() {
  return (
    <div class={css["whose"]} aria-hidden="true">
      <span>Name</span>
      <span>Date</span>
    </div>
  );
}

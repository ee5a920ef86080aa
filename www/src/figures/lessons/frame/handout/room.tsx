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

/** Where the page is, as one would type it. */
const address = () =>
  `${location.host}${location.pathname}#${location.hash.slice(1).split("/", 2).join("/")}`;

/** Whose handout it is, and where its page is; on paper only. */
export function Whose() {
  return (
    <div class={css["whose"]} aria-hidden="true">
      <span>Name</span>
      <span>Date</span>
      <span class={css["address"]}>{address()}</span>
    </div>
  );
}

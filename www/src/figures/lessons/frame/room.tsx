import "./handout.css";
import css from "./handout.module.css";

/** Lines to write on; on paper only. */
export function Room({ lines }: { lines: number }) {
  return (
    <div class={css["room"]} aria-hidden="true">
      {Array.from({ length: lines }, (_, i) => (
        <div key={`${i}`} />
      ))}
    </div>
  );
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

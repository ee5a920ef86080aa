import { useEffect } from "preact/hooks";
import { heldPlain } from "#document/deform/bend";

const hold = (on: boolean) => {
  heldPlain.value = on;
};

/** While it is held, the bend is the plain one: nothing is shuffled. */
export function PlainButton() {
  useEffect(() => () => hold(false), []);
  return (
    <button
      type="button"
      class="button plain-button"
      aria-pressed={heldPlain.value}
      title="Hold to see the plain bend, in which only the whole answers"
      onPointerDown={(event) => {
        if (event.button !== 0) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        hold(true);
      }}
      onPointerUp={() => hold(false)}
      onPointerCancel={() => hold(false)}
      onLostPointerCapture={() => hold(false)}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={(event) => {
        if (event.key !== " " && event.key !== "Enter") return;
        event.preventDefault();
        hold(true);
      }}
      onKeyUp={(event) => {
        if (event.key === " " || event.key === "Enter") hold(false);
      }}
      onBlur={() => hold(false)}
    >
      Hold for plain
    </button>
  );
}
